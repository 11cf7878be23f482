#include "lua/app/branch_moment.h"

#include <fmt/format.h>

#include <algorithm>

#include "picture/picture_run.h"

namespace lsos {

namespace {

std::string number_of(const EventRow& event) {
  return fmt::format("{}/{}", event.rover_id, event.sequence);
}

}  // namespace

SimTime branch_moment(const LogReader& log, const std::string& folder, const std::string& at) {
  std::vector<EventRow> named;
  std::vector<std::string> names;
  for (const EventRow& event : log.events()) {
    names.push_back(event.label);
    names.push_back(number_of(event));
    if (event.label == at || number_of(event) == at) named.push_back(event);
  }
  const auto refuse = [&](const std::string& why) {
    throw InputError({}, fmt::format("--at {}: {}", at, why));
  };
  if (named.size() > 1) {
    std::string all;
    for (const EventRow& event : named) all += (all.empty() ? "" : ", ") + number_of(event);
    refuse(fmt::format("{} events have this label: name one as {}", named.size(), all));
  }
  SimTime moment{};
  if (!named.empty()) {
    if (!named.front().start) refuse("this event did not begin in the run");
    moment = *named.front().start - exchange_period;
    if (moment < SimTime{}) refuse("begins with the mission: run a changed plan instead");
    return moment;
  }
  try {
    moment = time_since_start("--at", at, log.start());
  } catch (const InputError& error) {
    refuse(fmt::format("neither a time (UTC, or a duration from the start) nor an event of {}{}",
                       folder, did_you_mean(at, names)));
  }
  if (moment < SimTime{} || moment > log.last_sample_time()) {
    refuse(fmt::format("the run is from {} to {}", format_utc(log.start()),
                       format_utc(log.start() + log.last_sample_time())));
  }
  return round_up_to_exchange(moment);
}

EventReferences begun_events(const LogReader& log, SimTime moment) {
  EventReferences begun;
  for (const EventRow& event : log.events()) {
    if (event.status == EventStatus::disabled) continue;
    const std::optional<SimTime> since = event.start ? event.start : event.end;
    if (since && *since <= moment) begun.insert({event.rover_id, event.sequence});
  }
  return begun;
}

}  // namespace lsos
