#include "mission/events/event_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lsos {

bool EventRecord::has_ended() const {
  switch (status) {
    case EventStatus::completed:
    case EventStatus::failed:
    case EventStatus::skipped:
    case EventStatus::disabled:
      return true;
    default:
      return false;
  }
}

bool EventRecord::has_begun() const {
  return start || (has_ended() && status != EventStatus::disabled);
}

bool EventRecord::has_waited_in_vain() const {
  return status == EventStatus::not_started && !is_prevented && ready && end && *end > *ready;
}

void EventRecord::archive(Archive& a) {
  LSOS_ARCHIVE(a, status, reason, ready, start, end, distance_start_m, distance_m, used_start_j,
               energy_used_j, solar_start_j, solar_j, charge_start, charge_end, place.lon_rad,
               place.lat_rad, place.height_m, is_prevented, is_timed, is_written);
}

bool EventRecord::is_sound() const {
  const auto is_time = [](const std::optional<SimTime>& time) {
    return !time || *time >= SimTime{};
  };
  return is_time(ready) && is_time(start) && is_time(end) &&
         std::isfinite(place.lon_rad + place.lat_rad + place.height_m);
}

void EventRecords::insert(std::size_t index, bool is_timed) {
  EventRecord record;
  record.is_timed = is_timed;
  all_.insert(all_.begin() + static_cast<std::ptrdiff_t>(index), record);
}

SimTime EventRecords::last_end() const {
  SimTime last{};
  for (const EventRecord& record : all_) last = std::max(last, record.end.value_or(SimTime{}));
  return last;
}

void EventRecords::prevent_rest(SimTime now, const std::string& reason, bool is_failure,
                                bool timed_too) {
  for (EventRecord& record : all_) {
    if (record.status != EventStatus::not_started || record.end) continue;
    if (record.is_timed && !timed_too) continue;
    record.end = now;
    record.reason = reason;
    record.is_prevented = is_failure;
  }
}

void EventRecords::mark_changed(std::size_t index) {
  if (!all_[index].is_written) return;
  all_[index].is_written = false;
  changed_.push_back(index);
}

void EventRecords::mark_all_changed() {
  changed_.clear();
  for (std::size_t i = 0; i < all_.size(); ++i) {
    all_[i].is_written = true;
    if (all_[i].ready || all_[i].status == EventStatus::disabled) mark_changed(i);
  }
}

std::vector<std::size_t> EventRecords::take_changed() {
  for (const std::size_t index : changed_) all_[index].is_written = true;
  return std::exchange(changed_, {});
}

EventRow event_row(const PlanEvent& event, const EventRecord& record) {
  EventRow row;
  row.rover_id = event.rover_id;
  row.sequence = event.sequence;
  row.type = event.type;
  row.label = event.label;
  row.is_prevented = record.is_prevented;
  row.status = record.status == EventStatus::running   ? EventStatus::incomplete
               : record.status == EventStatus::waiting ? EventStatus::not_started
                                                       : record.status;
  row.reason = record.reason;
  row.ready = record.ready;
  row.start = record.start;
  // The end of an event without a start is internal and not logged.
  if (record.status != EventStatus::not_started) row.end = record.end;
  row.distance_m = record.distance_m;
  row.energy_used_j = record.energy_used_j;
  row.solar_j = record.solar_j;
  if (record.ready) row.place = record.place;
  return row;
}

}  // namespace lsos
