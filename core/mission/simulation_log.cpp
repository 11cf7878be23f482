// The log of a mission.
#include "mission/simulation.h"

namespace lsos {

void Simulation::set_log(LogWriter* log) {
  log_ = log;
  for (Rover& rover : rovers_) rover.sequence.write_events_anew();
}

void Simulation::log_rows() {
  for (std::size_t i = 0; i < rovers_.size(); ++i) {
    Rover& rover = rovers_[i];
    const std::vector<RoverAgent::Note> notes = rover.agent->take_notes();
    const std::vector<std::size_t> events = rover.sequence.take_changed_events();
    const std::vector<PhaseRow> phases = rover.sequence.take_phases();
    const std::vector<PlannedPathRow> paths = rover.agent->routes().take_rows();
    for (const RoverAgent::Note& note : notes) {
      const NoteRow row{now_,      rover.agent->id(), note.sequence,
                        note.name, note.fields_json,  rover.agent->place_now()};
      if (note_listener_) note_listener_(row);
      if (log_ != nullptr) log_->write(row);
    }
    if (log_ == nullptr) continue;
    for (const std::size_t event : events) log_->write(rover.sequence.row(event));
    for (const PhaseRow& phase : phases) log_->write(phase);
    for (const PlannedPathRow& path : paths) log_->write(path);
    if (is_sample_due(rover)) log_sample(i);
  }
  if (log_ != nullptr && sight_ && assets_logged_ != now_ &&
      now_ % setup_.plan.mission.parked_log_interval == SimTime{}) {
    for (std::size_t i = 0; i < assets_.size(); ++i) log_pairs(rovers_.size() + i);
    assets_logged_ = now_;
  }
  if (log_ != nullptr) log_->commit_if_due();
}

void Simulation::log_sample(std::size_t number) {
  Rover& rover = rovers_[number];
  SampleRow sample =
      rover.agent->sample(now_, rover.sequence.event_label(), rover.sequence.phase());
  if (now_ == SimTime{}) rover.agent->power().fill_start(sample);
  log_->write(sample);
  for (const JointRow& row : rover.agent->joints(now_)) log_->write(row);
  for (const PanelRow& row : rover.agent->panels(now_)) log_->write(row);
  for (const ResourceRow& row : rover.agent->resources(now_)) log_->write(row);
  if (sight_) log_pairs(number);
  rover.logged = now_;
}

bool Simulation::is_sample_due(const Rover& rover) const {
  if (rover.logged == now_) return false;
  const MissionInfo& mission = setup_.plan.mission;
  const SimTime interval =
      rover.agent->is_parked() ? mission.parked_log_interval : mission.log_interval;
  return now_ % interval == SimTime{};
}

SimTime Simulation::next_sample(const Rover& rover) const {
  const MissionInfo& mission = setup_.plan.mission;
  const SimTime interval =
      rover.agent->is_parked() ? mission.parked_log_interval : mission.log_interval;
  return (now_ / interval + 1) * interval;
}

void Simulation::terminate() {
  log_rows();
  warn_of_ends();
  if (log_ == nullptr) return;
  for (std::size_t i = 0; i < rovers_.size(); ++i) {
    if (rovers_[i].logged != now_) log_sample(i);
  }
  if (sight_) finish_sight();
  for (const Rover& rover : rovers_) {
    for (std::size_t i = 0; i < rover.sequence.records().size(); ++i) {
      if (!rover.sequence.records()[i].ready) log_->write(rover.sequence.row(i));
    }
  }
}

}  // namespace lsos
