// Log rows of a rover's events.
#include <utility>

#include "mission/events/event_sequence.h"

namespace lsos {

std::string EventSequence::event_label() const { return running_ ? event().label : ""; }
std::string EventSequence::phase() const { return running_ ? running_->phase() : ""; }

EventRow EventSequence::row(std::size_t index) const {
  const PlanEvent& event = machine_.events[index].event;
  const EventRecord& record = records_[index];
  EventRow row;
  row.rover_id = event.rover_id;
  row.sequence = event.sequence;
  row.type = event.type;
  row.label = event.label;
  // Until an event ends, its row holds the state in which a killed program would leave it.
  row.is_prevented = record.is_prevented;
  row.status = record.status == EventStatus::running   ? EventStatus::incomplete
               : record.status == EventStatus::waiting ? EventStatus::not_started
                                                       : record.status;
  row.reason = record.reason;
  row.ready = record.ready;
  row.start = record.start;
  // The end that finish() gives to an event without a start is internal and not logged.
  if (record.status != EventStatus::not_started) row.end = record.end;
  row.distance_m = record.distance_m;
  row.energy_used_j = record.energy_used_j;
  row.solar_j = record.solar_j;
  if (record.ready) row.place = record.place;
  return row;
}

void EventSequence::changed(std::size_t index) {
  if (!records_[index].is_written) return;
  records_[index].is_written = false;
  changed_.push_back(index);
}

std::vector<std::size_t> EventSequence::take_changed_events() {
  for (const std::size_t index : changed_) records_[index].is_written = true;
  return std::exchange(changed_, {});
}

void EventSequence::write_events_anew() {
  changed_.clear();
  for (std::size_t i = 0; i < records_.size(); ++i) {
    records_[i].is_written = true;
    if (records_[i].ready || records_[i].end) changed(i);
  }
}

std::vector<PhaseRow> EventSequence::take_phases() {
  if (running_) {
    for (PhaseRow& phase : running_->take_phases()) phases_.push_back(std::move(phase));
  }
  return std::exchange(phases_, {});
}
std::vector<std::string> EventSequence::take_warnings() { return std::exchange(warnings_, {}); }

}  // namespace lsos
