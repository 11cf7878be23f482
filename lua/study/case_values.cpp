#include "lua/study/case_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "edit/event_names.h"
#include "lua/api/api.h"
#include "lua/host/condition.h"
#include "lua/host/host.h"
#include "lua/runtime/state.h"
#include "plan/suggestions.h"
#include "product/study/case_series.h"
#include "record/log.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;
using Take = Gathering::Take;

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const ConditionName& each : condition_names()) {
    if (!is_question(each.name)) names.emplace_back(each.name);
  }
  return names;
}

std::vector<std::string> rover_ids(const Plan& plan) {
  std::vector<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.push_back(rover.id);
  return ids;
}

// Checks one gathering, and says what it lacks.
class GatheringCheck {
 public:
  GatheringCheck(const StudyFiles& files, Gathering& gathering, Faults& faults)
      : plan_(files.base.plan), files_(files), gathering_(gathering), faults_(faults) {}

  void run() {
    if (gathering_.take == Take::summary) {
      check_path();
    } else if (!gathering_.event.empty()) {
      find_event();
    } else {
      check_known("rover", gathering_.rover, rover_ids(plan_));
    }
    if (!gathering_.quantity.empty()) {
      check_known("quantity", gathering_.quantity, quantity_names());
    }
    if (gathering_.take == Take::share) check_condition();
    if (gathering_.name.empty()) gathering_.name = default_name();
  }

 private:
  void refuse(const std::string& why) { faults_.error(gathering_.place, "gather: " + why); }

  void check_known(const char* what, const std::string& name,
                   const std::vector<std::string>& known) {
    if (std::ranges::count(known, name) > 0) return;
    const std::string hint = did_you_mean(name, known);
    refuse(fmt::format("there is no {} '{}'{}", what, name,
                       hint.empty() ? "; there are " + listed(known) : hint));
  }

  void find_event() {
    const EventNames names(plan_);
    const auto meant = names.meanings(gathering_.event);
    if (meant.size() == 1) {
      gathering_.rover = meant.front()->rover_id;
      gathering_.event = reference_text(reference_to(*meant.front()));
      return;
    }
    std::vector<std::string> known;
    for (const PlanEvent& event : plan_.events) {
      known.push_back(event.label);
      known.push_back(reference_text(reference_to(event)));
    }
    refuse(meant.empty() ? fmt::format("the plan has no event '{}'{}", gathering_.event,
                                       did_you_mean(gathering_.event, known))
                         : fmt::format("{} events are called '{}'; ROVER/SEQUENCE says which",
                                       meant.size(), gathering_.event));
  }

  // The words of a path whose values are known before anything runs.
  void check_path() {
    const std::string& path = gathering_.path;
    const std::size_t point = path.find('.');
    const std::string first = path.substr(0, point);
    check_known("value in summary.json called", first,
                {"status", "log_sha256", "sim_s", "wall_s", "real_time_factor", "rovers", "events",
                 "plan"});
    if (first == "rovers" || first == "events") {
      std::vector<std::string> known = rover_ids(plan_);
      if (first == "events") {
        known.clear();
        for (const PlanEvent& event : plan_.events) {
          known.push_back(reference_text(reference_to(event)));
        }
      }
      const std::string rest = point == std::string::npos ? "" : path.substr(point + 1);
      const bool is_known = std::ranges::any_of(known, [&](const std::string& name) {
        return rest.starts_with(name + ".") && rest.size() > name.size() + 1;
      });
      if (is_known) return;
      refuse(fmt::format("summary = '{}': '{}.NAME.VALUE' is wanted; there are {}", path, first,
                         listed(known)));
    }
  }

  void check_condition() {
    if (has_question(gathering_.condition)) {
      refuse(
          fmt::format("share_when = '{}': the log's samples do not say what a question asks; "
                      "quantities do",
                      gathering_.condition));
      return;
    }
    LuaHost host(*files_.base.catalog);
    const std::string fault = host.condition_fault(gathering_.condition, {});
    if (!fault.empty()) {
      refuse(fmt::format("share_when = '{}': {}", gathering_.condition, fault));
    }
  }

  std::string default_name() const {
    switch (gathering_.take) {
      case Take::summary:
        return gathering_.path;
      case Take::at_start:
        return fmt::format("{} {} at start", gathering_.event, gathering_.quantity);
      case Take::at_end:
        return fmt::format("{} {} at end", gathering_.event, gathering_.quantity);
      case Take::least:
        return fmt::format("{} least {}", gathering_.rover, gathering_.quantity);
      case Take::greatest:
        return fmt::format("{} greatest {}", gathering_.rover, gathering_.quantity);
      case Take::share:
        break;
    }
    return fmt::format("{} share of time with {}", gathering_.rover, gathering_.condition);
  }

  const Plan& plan_;
  const StudyFiles& files_;
  Gathering& gathering_;
  Faults& faults_;
};

// A value that is wanted at one time of a rover.
struct Probe {
  double time_s = 0;
  std::string quantity;
  double* value = nullptr;
};

// Goes through the samples of a log once, rover by rover.
class SampleWalk {
 public:
  SampleWalk(const std::vector<Gathering>& gatherings, lua_State* L)
      : gatherings_(gatherings), L_(L), extremes_(gatherings.size()), held_s_(gatherings.size()) {}

  void add_probe(const std::string& rover, Probe probe) { probes_[rover].push_back(probe); }

  void add(const SampleRow& row) {
    const auto last = last_.find(row.rover_id);
    for (Probe& probe : probes_[row.rover_id]) take(probe, last, row);
    for (std::size_t i = 0; i < gatherings_.size(); ++i) {
      const Gathering& gathering = gatherings_[i];
      if (gathering.rover != row.rover_id) continue;
      if (gathering.take == Take::least || gathering.take == Take::greatest) extend(i, row);
      if (gathering.take == Take::share) count_time(i, row, last);
    }
    last_[row.rover_id] = row;
  }

  std::optional<double> result(std::size_t index) const {
    const Gathering& gathering = gatherings_[index];
    if (gathering.take != Take::share) return extremes_[index];
    const auto last = last_.find(gathering.rover);
    if (last == last_.end() || !(seconds(last->second.time) > 0)) return {};
    return held_s_[index] / seconds(last->second.time);
  }

 private:
  using Last = std::map<std::string, SampleRow>::const_iterator;

  void take(Probe& probe, Last last, const SampleRow& row) const {
    if (std::isfinite(*probe.value)) return;
    const double at_s = seconds(row.time);
    if (probe.time_s > at_s) return;
    const auto now = condition_quantity(probe.quantity, row);
    if (!now) return;
    *probe.value = *now;
    if (last == last_.end()) return;
    const double from_s = seconds(last->second.time);
    const double before = *condition_quantity(probe.quantity, last->second);
    const double share = at_s > from_s ? (probe.time_s - from_s) / (at_s - from_s) : 1;
    *probe.value = between(before, *now, share);
  }

  void extend(std::size_t index, const SampleRow& row) {
    const auto value = condition_quantity(gatherings_[index].quantity, row);
    if (!value || !std::isfinite(*value)) return;
    std::optional<double>& extreme = extremes_[index];
    const bool is_least = gatherings_[index].take == Take::least;
    if (!extreme) extreme = *value;
    extreme = is_least ? std::min(*extreme, *value) : std::max(*extreme, *value);
  }

  // What holds at a sample holds until the next.
  void count_time(std::size_t index, const SampleRow& row, Last last) {
    if (last == last_.end()) return;
    if (condition_holds(L_, gatherings_[index].condition, last->second)) {
      held_s_[index] += seconds(row.time - last->second.time);
    }
  }

  const std::vector<Gathering>& gatherings_;
  lua_State* L_;
  std::map<std::string, std::vector<Probe>> probes_;
  std::map<std::string, SampleRow> last_;
  std::vector<std::optional<double>> extremes_;
  std::vector<double> held_s_;
};

// The value at a path of names; an event of the list is named ROVER/SEQUENCE, and names may have
// points in them.
const Json* at_path(const Json& json, const std::string& path) {
  if (path.empty()) return &json;
  if (json.is_array()) {
    for (const Json& each : json) {
      if (!each.is_object() || !each.contains("rover_id") || !each.contains("sequence")) continue;
      const std::string name = fmt::format("{}/{}", each["rover_id"].get<std::string>(),
                                           each["sequence"].get<std::int64_t>());
      if (path.starts_with(name + ".")) return at_path(each, path.substr(name.size() + 1));
    }
    return nullptr;
  }
  if (!json.is_object()) return nullptr;
  for (const auto& [name, value] : json.items()) {
    if (path == name) return &value;
    if (!path.starts_with(name + ".")) continue;
    if (const Json* found = at_path(value, path.substr(name.size() + 1))) return found;
  }
  return nullptr;
}

std::optional<Draw::Value> plain_value(const Json* json) {
  if (json == nullptr) return {};
  if (json->is_boolean()) return json->get<bool>();
  if (json->is_number()) return json->get<double>();
  if (json->is_string()) return json->get<std::string>();
  return {};
}

std::map<std::string, EventRow> events_by_name(const std::vector<EventRow>& rows) {
  std::map<std::string, EventRow> events;
  for (const EventRow& row : rows) {
    events[fmt::format("{}/{}", row.rover_id, row.sequence)] = row;
  }
  return events;
}

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void check_gatherings(StudyFiles& files, Faults& faults) {
  std::map<std::string, Place> known;
  for (Gathering& gathering : files.study.gathered) {
    GatheringCheck(files, gathering, faults).run();
    const auto [first, is_new] = known.emplace(gathering.name, gathering.place);
    if (is_new) continue;
    faults.error(gathering.place,
                 fmt::format("gather: '{}' is gathered already, see {}; 'name' "
                             "says another",
                             gathering.name, line_text(first->second, gathering.place.file)));
  }
}

CaseValues values_of_case(const StudyFiles& files, const std::string& folder,
                          const std::string& summary_text) {
  const Json summary = Json::parse(summary_text);
  const LogReader log(folder + "/log.gpkg");
  const std::vector<EventRow> rows = log.events();
  const std::vector<Gathering>& gatherings = files.study.gathered;
  CaseValues values;
  std::vector<double> gathered(gatherings.size(), absent), charges(rows.size(), absent);

  LuaState lua(make_api);
  lua.run([&](lua_State* L) {
    SampleWalk walk(gatherings, L);
    const std::map<std::string, EventRow> events = events_by_name(rows);
    for (std::size_t i = 0; i < gatherings.size(); ++i) {
      const bool is_start = gatherings[i].take == Take::at_start;
      if (!is_start && gatherings[i].take != Take::at_end) continue;
      const auto event = events.find(gatherings[i].event);
      if (event == events.end()) continue;
      const auto& moment = is_start ? event->second.start : event->second.end;
      if (!moment) continue;
      walk.add_probe(gatherings[i].rover, {seconds(*moment), gatherings[i].quantity, &gathered[i]});
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].end)
        walk.add_probe(rows[i].rover_id, {seconds(*rows[i].end), "charge", &charges[i]});
    }
    SeriesRecorder recorder(files.interval_s, rover_ids(files.base.plan));
    log.for_each_sample([&](const SampleRow& row) {
      recorder.add(row);
      walk.add(row);
    });
    values.series = recorder.bytes();
    for (std::size_t i = 0; i < gatherings.size(); ++i) {
      if (const auto result = walk.result(i)) gathered[i] = *result;
    }
  });
  for (std::size_t i = 0; i < gatherings.size(); ++i) {
    if (gatherings[i].take == Take::summary) {
      if (const auto value = plain_value(at_path(summary, gatherings[i].path))) {
        values.gathered.emplace_back(gatherings[i].name, *value);
      }
    } else if (std::isfinite(gathered[i])) {
      values.gathered.emplace_back(gatherings[i].name, gathered[i]);
    }
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const EventRow& row = rows[i];
    CaseRecord::Event event{row.rover_id, row.sequence, to_string(row.status),
                            row.reason,   std::nullopt, std::nullopt,
                            row.place};
    if (row.end) event.end_s = seconds(*row.end);
    if (std::isfinite(charges[i])) event.charge = charges[i];
    values.events.push_back(std::move(event));
  }
  return values;
}

}  // namespace lsos
