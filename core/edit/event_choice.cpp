#include "edit/event_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/error.h"
#include "base/quantity.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

struct Range {
  std::string rover_id;
  std::int64_t first = 0, last = 0;
};

void check_known(const std::string& subject, const std::string& name, const char* what,
                 std::vector<std::string> known) {
  if (name.empty() || std::ranges::find(known, name) != known.end()) return;
  std::ranges::sort(known);
  known.erase(std::unique(known.begin(), known.end()), known.end());
  std::string hint = Suggestions(known)(name);
  if (hint.empty()) hint = fmt::format("; there are {}", listed(known));
  throw InputError({},
                   fmt::format("{}: the plan has no {} {}{}", subject, what, quoted(name), hint));
}

std::vector<std::string> rover_ids(const Plan& plan) {
  std::vector<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.push_back(rover.id);
  return ids;
}

Range read_range(const Plan& plan, const std::string& text) {
  const std::size_t slash = text.rfind('/');
  const std::size_t dots = slash == std::string::npos ? slash : text.find("..", slash);
  const bool is_open = dots == std::string::npos;
  const auto number = [&](std::size_t from, std::size_t to) {
    return slash == std::string::npos ? Parsed<std::int64_t>{}
                                      : parse_integer(text.substr(from, to - from));
  };
  const Parsed<std::int64_t> first = number(slash + 1, is_open ? text.size() : dots);
  const Parsed<std::int64_t> last = is_open ? first : number(dots + 2, text.size());
  if (!first || !last || *first.value > *last.value) {
    throw InputError({}, fmt::format("{}: ROVER/SEQUENCE or ROVER/FIRST..LAST is wanted, such as "
                                     "SEV1/20 or SEV1/20..40; --label takes a label",
                                     quoted(text)));
  }
  const Range range{text.substr(0, slash), *first.value, *last.value};
  check_known(quoted(text), range.rover_id, "rover", rover_ids(plan));
  const bool has_any = std::ranges::any_of(plan.events, [&](const PlanEvent& event) {
    return event.rover_id == range.rover_id && event.sequence >= range.first &&
           event.sequence <= range.last;
  });
  if (!has_any) {
    std::vector<std::string> known;
    for (const PlanEvent& event : plan.events) {
      if (event.rover_id == range.rover_id) known.push_back(std::to_string(event.sequence));
    }
    throw InputError({}, fmt::format("{}: rover {} has no event there; its sequences are {}",
                                     quoted(text), quoted(range.rover_id), listed(known)));
  }
  return range;
}

}  // namespace

void check_rover(const Plan& plan, const std::string& option, const std::string& rover_id) {
  check_known(option + " " + rover_id, rover_id, "rover", rover_ids(plan));
}

std::vector<const PlanEvent*> chosen_events(const Plan& plan, const EventChoice& choice,
                                            const EventDays& days) {
  std::vector<Range> ranges;
  for (const std::string& text : choice.ranges) ranges.push_back(read_range(plan, text));
  check_rover(plan, "--rover", choice.rover_id);
  std::vector<std::string> labels, types;
  for (const PlanEvent& event : plan.events) {
    labels.push_back(event.label);
    types.push_back(event.type);
  }
  check_known("--label " + choice.label, choice.label, "event", std::move(labels));
  check_known("--type " + choice.type, choice.type, "event of type", std::move(types));
  std::vector<const PlanEvent*> chosen;
  int last_day = 1;
  for (const PlanEvent& event : plan.events) {
    const int day = days.at({event.rover_id, event.sequence});
    last_day = std::max(last_day, day);
    const bool is_in_range = ranges.empty() || std::ranges::any_of(ranges, [&](const Range& range) {
                               return event.rover_id == range.rover_id &&
                                      event.sequence >= range.first && event.sequence <= range.last;
                             });
    const bool is_on_day =
        choice.first_day == 0 || (day >= choice.first_day && day <= choice.last_day);
    const auto is_or_any = [](const std::string& wanted, const std::string& has) {
      return wanted.empty() || wanted == has;
    };
    if (is_in_range && is_on_day && is_or_any(choice.rover_id, event.rover_id) &&
        is_or_any(choice.label, event.label) && is_or_any(choice.type, event.type)) {
      chosen.push_back(&event);
    }
  }
  if (chosen.empty()) {
    throw InputError({}, fmt::format("no event of the plan is meant{}; it has {} events on {} "
                                     "day{}",
                                     choice.first_day > 0 ? " (days are counted from the mission's "
                                                            "start, from 1)"
                                                          : "",
                                     plan.events.size(), last_day, last_day == 1 ? "" : "s"));
  }
  return chosen;
}

}  // namespace lsos
