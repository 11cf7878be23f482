#include "mission/estimate/estimate_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "planet/utc.h"

namespace lsos {

namespace {

bool is_known(const PlanEvent& event, const std::vector<Fault>& known) {
  const std::string name = fmt::format("'{}'", event.label);
  return std::ranges::any_of(known, [&](const Fault& fault) {
    const bool is_there =
        fault.place.line == event.place.line || fault.place.line == event.geometry.line;
    // A Timeout that is short is told before the start; what comes of it is not.
    return fault.place.file == event.place.file && is_there &&
           fault.what.find(name) != std::string::npos &&
           fault.what.find("Timeout = ") == std::string::npos;
  });
}

// Events that do not take place as drawn because this one has failed or is cut off.
std::vector<const EventEstimate*> prevented_by(const EventEstimate& event,
                                               const std::vector<EventEstimate>& events) {
  const std::string failed = fmt::format("'{}' failed", event.label),
                    aborts = fmt::format("'{}' of {} failed and aborts the mission", event.label,
                                         event.rover_id);
  std::vector<const EventEstimate*> prevented;
  for (const EventEstimate& other : events) {
    if (&other == &event || other.status == EventStatus::completed) continue;
    const bool is_later = other.rover_id == event.rover_id && other.sequence > event.sequence;
    const bool is_cut_off = event.status == EventStatus::incomplete && is_later &&
                            other.status == EventStatus::not_started;
    if ((is_later && other.reason == failed) || other.reason.starts_with(aborts) || is_cut_off) {
      prevented.push_back(&other);
    }
  }
  return prevented;
}

std::string prevented_text(const std::vector<const EventEstimate*>& prevented) {
  if (prevented.empty()) return "";
  const std::string& first = prevented.front()->label;
  if (prevented.size() == 1) return fmt::format("; '{}' then does not take place", first);
  return fmt::format("; '{}' and {} more then do not take place", first, prevented.size() - 1);
}

// What a planner must hear of an event; "" where there is nothing.
std::string news_of(const EventEstimate& event, const std::vector<EventEstimate>& events,
                    const Plan& plan) {
  const auto utc = [&](const std::optional<double>& time_s) {
    return format_utc(plan.mission.start_time + from_seconds(*time_s));
  };
  const std::vector<const EventEstimate*> prevented = prevented_by(event, events);
  if (event.status == EventStatus::failed && event.over_s) {
    // A condition that the plan has for ending it says what is meant, unless nothing comes then.
    if (event.reason.starts_with("StopWhen: ") && prevented.empty()) return "";
    std::string what = fmt::format("it fails at {}{}: {}", utc(event.over_s),
                                   event.start_s ? "" : ", before it begins", event.reason);
    if (event.distance_m && *event.distance_m > 0) {
      what += fmt::format(", having driven {:.1f} km", *event.distance_m / 1000);
    }
    return what + prevented_text(prevented);
  }
  const bool is_aborted = event.reason.find("aborts the mission") != std::string::npos;
  if (event.status == EventStatus::incomplete && event.over_s && !is_aborted) {
    return fmt::format("it is cut off at {}: {}{}", utc(event.over_s), event.reason,
                       prevented_text(prevented));
  }
  if (event.waits_in_vain) {
    return fmt::format("its turn comes at {} and it never starts: {}", utc(event.ready_s),
                       event.reason);
  }
  if (event.meets.empty()) return "";
  return fmt::format(
      "{} stands where it ends at {}: a run ends it before they touch; give each a place of its "
      "own, some metres apart",
      event.meets, utc(event.end_s));
}

}  // namespace

std::vector<Fault> estimate_warnings(const std::vector<EventEstimate>& events, const Plan& plan,
                                     const std::vector<Fault>& known) {
  std::vector<Fault> warnings;
  for (const EventEstimate& event : events) {
    const auto planned = std::ranges::find_if(plan.events, [&](const PlanEvent& other) {
      return other.rover_id == event.rover_id && other.sequence == event.sequence;
    });
    if (planned == plan.events.end()) continue;
    const std::string news = news_of(event, events, plan);
    // What cuts an event off is not of its own.
    const bool is_cut_off = event.status == EventStatus::incomplete;
    if (news.empty() || (!is_cut_off && is_known(*planned, known))) continue;
    warnings.push_back({Severity::warning, planned->place,
                        fmt::format("{} '{}': by the estimate {}", event.type, event.label, news)});
  }
  return warnings;
}

}  // namespace lsos
