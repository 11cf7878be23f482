#include "lua/study/case_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "lua/api/api.h"
#include "lua/host/condition.h"
#include "lua/runtime/state.h"
#include "lua/study/gathering_check.h"
#include "product/study/case_series.h"
#include "record/log.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;
using Take = Gathering::Take;

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

  // Where the rover was last; absent without a sample.
  std::optional<Geodetic> last_place(const std::string& rover) const {
    const auto last = last_.find(rover);
    return last == last_.end() ? std::nullopt : std::optional(last->second.place);
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

CaseValues values_of_case(const StudyFiles& files, const std::string& folder,
                          const std::string& summary_text) {
  const Json summary = Json::parse(summary_text);
  const LogReader log(folder + "/log.gpkg");
  const std::vector<EventRow> rows = log.events();
  const std::vector<Gathering>& gatherings = files.study.gathered;
  CaseValues values;
  std::vector<double> gathered(gatherings.size(), absent), charges(rows.size(), absent);

  std::map<std::string, std::optional<Geodetic>> last_places;
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
    for (const std::string& rover : rover_ids(files.base.plan)) {
      last_places[rover] = walk.last_place(rover);
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
  // The first event of each rover that did not end is where its mission ended.
  for (CaseRecord::Event& event : values.events) {
    const bool has_not_ended = event.status == "incomplete" || event.status == "not_started";
    const auto last = last_places.find(event.rover_id);
    if (!has_not_ended || last == last_places.end()) continue;
    if (!event.place) event.place = last->second;
    last_places.erase(last);
  }
  return values;
}

}  // namespace lsos
