#include "mission/fleet/mission_log.h"

#include "mission/rover/rover_rows.h"

namespace lsos {

void MissionLog::set_writer(LogWriter* writer, Fleet& fleet) {
  writer_ = writer;
  last_orders_.clear();
  for (FleetRover& rover : fleet.rovers) rover.sequence.records().mark_all_changed();
}

void MissionLog::write(const NoteRow& note) {
  if (listener_) listener_(note);
  if (writer_ != nullptr) writer_->write(note);
}

void MissionLog::write(const std::vector<SightIntervalRow>& intervals) {
  if (writer_ == nullptr) return;
  for (const SightIntervalRow& row : intervals) writer_->write(row);
}

void MissionLog::write(Fleet& fleet, const FleetSight* sight, const Moment& moment) {
  for (std::size_t i = 0; i < fleet.rovers.size(); ++i) {
    FleetRover& rover = fleet.rovers[i];
    write_changes(rover, moment.now);
    if (writer_ != nullptr && rover.logged != moment.now && is_due(rover, moment.now)) {
      write_sample(fleet, sight, moment, i);
    }
    rover.is_logged_as_parked = rover.agent->is_parked();
  }
  if (writer_ == nullptr) return;
  if (sight != nullptr && assets_logged_ != moment.now &&
      moment.now % parked_interval_ == SimTime{}) {
    for (std::size_t i = 0; i < fleet.assets.size(); ++i) {
      write_pairs(fleet, *sight, moment, fleet.rovers.size() + i);
    }
    assets_logged_ = moment.now;
  }
  writer_->commit_if_due();
}

void MissionLog::write_changes(Fleet& fleet, SimTime now) {
  for (FleetRover& rover : fleet.rovers) write_changes(rover, now);
}

void MissionLog::write_notes(Fleet& fleet, SimTime now) {
  for (FleetRover& rover : fleet.rovers) write_notes(*rover.agent, now);
}

void MissionLog::write_notes(RoverAgent& agent, SimTime now) {
  for (const RoverJournal::Note& note : agent.journal().take_notes()) {
    write(NoteRow{now, agent.id(), note.sequence, note.name, note.fields_json,
                  agent.motion().place()});
  }
}

// Notes, events, phases and planned paths since the last exchange; taken also when there is no log.
void MissionLog::write_changes(FleetRover& rover, SimTime now) {
  RoverAgent& agent = *rover.agent;
  const std::vector<std::size_t> events = rover.sequence.records().take_changed();
  const std::vector<PhaseRow> phases = rover.sequence.take_phases();
  const std::vector<PlannedPathRow> paths = agent.routes().take_rows();
  write_notes(agent, now);
  if (writer_ == nullptr) return;
  for (const std::size_t event : events) writer_->write(rover.sequence.row(event));
  for (const PhaseRow& phase : phases) writer_->write(phase);
  for (const PlannedPathRow& path : paths) writer_->write(path);
}

void MissionLog::write_sample(Fleet& fleet, const FleetSight* sight, const Moment& moment,
                              std::size_t number) {
  FleetRover& rover = fleet.rovers[number];
  const RoverAgent& agent = *rover.agent;
  SampleRow sample =
      sample_row(agent, moment.now, rover.sequence.event_label(), rover.sequence.phase());
  if (moment.now == SimTime{}) agent.power().fill_start(sample);
  writer_->write(sample);
  for (const JointRow& row : joint_rows(agent, moment.now)) writer_->write(row);
  for (const PanelRow& row : panel_rows(agent, moment.now)) writer_->write(row);
  for (const ResourceRow& row : resource_rows(agent, moment.now)) writer_->write(row);
  for (const OrderRow& row : order_rows(agent, moment.now)) {
    OrderRow& last = last_orders_[{row.rover_id, row.part + " " + row.name}];
    if (row.orders_same(last)) continue;
    writer_->write(row);
    last = row;
  }
  if (sight != nullptr) write_pairs(fleet, *sight, moment, number);
  rover.logged = moment.now;
}

void MissionLog::write_pairs(const Fleet& fleet, const FleetSight& sight, const Moment& moment,
                             std::size_t from) {
  for (const PairRow& row : sight.rows(fleet, moment, from)) writer_->write(row);
}

// A sample where a rover parks or leaves, too: else a line from one sample to the next would show
// it slowing down over all of the interval of a parked rover.
bool MissionLog::is_due(const FleetRover& rover, SimTime now) const {
  const bool parks_or_leaves = rover.is_logged_as_parked != rover.agent->is_parked();
  return (parks_or_leaves && parked_interval_ != interval_) || now % interval(rover) == SimTime{};
}

SimTime MissionLog::interval(const FleetRover& rover) const {
  return rover.agent->is_parked() ? parked_interval_ : interval_;
}

SimTime MissionLog::next_sample(const FleetRover& rover, SimTime now) const {
  return (now / interval(rover) + 1) * interval(rover);
}

void MissionLog::finish(Fleet& fleet, FleetSight* sight, const Moment& moment) {
  if (writer_ == nullptr) return;
  for (std::size_t i = 0; i < fleet.rovers.size(); ++i) {
    if (fleet.rovers[i].logged != moment.now) write_sample(fleet, sight, moment, i);
  }
  if (sight != nullptr) write(sight->finish(fleet, moment.now));
  for (const FleetRover& rover : fleet.rovers) {
    for (std::size_t i = 0; i < rover.sequence.records().size(); ++i) {
      if (!rover.sequence.records()[i].ready) writer_->write(rover.sequence.row(i));
    }
  }
}

}  // namespace lsos
