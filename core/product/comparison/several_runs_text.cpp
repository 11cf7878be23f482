#include "product/comparison/several_runs_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/sim_time.h"
#include "product/comparison/text_table.h"
#include "product/quantity_text.h"

namespace lsos {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* no_value = "-";
constexpr const char* as_first = "=";  // a value that is that of the first run

std::string value_text(const std::string& quantity, double value) {
  return std::isnan(value) ? no_value : quantity_text(quantity, value);
}

Cells event_cells(const EventRow& event) {
  return {to_string(event.status), clock_text(event.start), clock_text(event.end),
          value_text("distance_m", event.distance_m),
          value_text("energy_used_j", event.energy_used_j)};
}

std::string event_table(const EventOutcomes& outcomes) {
  std::vector<Cells> rows{{"", "status", "start", "end", "distance", "energy used"}};
  const auto absent = [] { return Cells{"no such event", "", "", "", ""}; };
  const Cells first = outcomes.runs.front() ? event_cells(*outcomes.runs.front()) : absent();
  for (std::size_t k = 0; k < outcomes.runs.size(); ++k) {
    if (k > 0 && !outcomes.differs(k)) continue;
    Cells cells = outcomes.runs[k] ? event_cells(*outcomes.runs[k]) : absent();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (k > 0 && cells[i] == first[i] && !cells[i].empty()) cells[i] = as_first;
    }
    cells.insert(cells.begin(), run_name(k));
    rows.push_back(std::move(cells));
  }
  return fmt::format("\nevent {}/{} {}\n{}", outcomes.rover_id, outcomes.sequence, outcomes.label,
                     text_table(rows));
}

// null where the object has no such key.
Json at(const Json& object, const std::string& key) {
  return object.is_object() && object.contains(key) ? object.at(key) : Json();
}

Json parsed(const RunOutcome& run) {
  const Json summary = Json::parse(run.summary, nullptr, false);
  return summary.is_object() ? summary : Json();
}

std::string status_of(const RunOutcome& run) {
  const Json status = at(parsed(run), "status");
  return status.is_string() ? status.get<std::string>() : "not finished";
}

std::string totals(const SeveralRuns& several) {
  std::set<std::string> rover_ids;
  std::vector<Json> rovers;
  for (const RunOutcome& run : several.runs) {
    rovers.push_back(at(parsed(run), "rovers"));
    for (const auto& [id, values] : rovers.back().items()) rover_ids.insert(id);
  }
  std::string text;
  for (const std::string& id : rover_ids) {
    std::vector<Cells> rows{
        {"", "distance", "duration", "driving", "energy used", "from the Sun", "energy at end"}};
    for (std::size_t k = 0; k < several.runs.size(); ++k) {
      const Json values = at(rovers[k], id);
      Cells cells{run_name(k)};
      const auto add = [&](const char* key, bool is_time) {
        const Json value = at(values, key);
        if (!value.is_number()) {
          cells.emplace_back(no_value);
        } else if (is_time) {
          cells.push_back(clock_text(from_seconds(value.get<double>())));
        } else {
          cells.push_back(quantity_text(key, value.get<double>()));
        }
      };
      add("distance_m", false);
      add("duration_s", true);
      add("drive_s", true);
      for (const char* key : {"energy_used_j", "solar_j", "energy_end_j"}) add(key, false);
      rows.push_back(std::move(cells));
    }
    text += fmt::format("\nrover {}\n{}", id, text_table(rows));
  }
  return text;
}

// What became of a run beside the first: "the same as A".
std::string beside_first(const SeveralRuns& several, std::size_t run) {
  if (run == 0) return "";
  const Comparison& found = several.with_first[run - 1];
  if (found.is_equal()) {
    return found.has_equal_logs() ? ", equal to A, log and all" : ", came to the same as A";
  }
  if (!found.logs[0].matches() || !found.logs[1].matches()) return "";  // that is told by itself
  const bool is_in_table = std::ranges::any_of(
      several.events, [&](const EventOutcomes& event) { return event.differs(run); });
  return is_in_table ? "" : ", differs from A in other values: compare it with A alone";
}

// What the run is made of that the first is not: plan, scripts, start. Events of other plans that
// have the same number need not be the same.
std::string other_making(const Comparison& found) {
  std::string names;
  for (const Difference& difference : found.made_of) {
    names += (names.empty() ? "" : ", ") + difference.quantity;
  }
  return names.empty() ? "" : fmt::format("  made of other {}\n", names);
}

}  // namespace

nlohmann::ordered_json events_json(const std::vector<EventOutcomes>& events) {
  Json array = Json::array();
  for (const EventOutcomes& outcomes : events) {
    Json runs = Json::array();
    for (std::size_t k = 0; k < outcomes.runs.size(); ++k) {
      const std::optional<EventRow>& event = outcomes.runs[k];
      if (!event) {
        runs.push_back(nullptr);
        continue;
      }
      const auto time = [](std::optional<SimTime> at) { return at ? Json(seconds(*at)) : Json(); };
      runs.push_back({{"run", run_name(k)},
                      {"differs", outcomes.differs(k)},
                      {"status", to_string(event->status)},
                      {"start_s", time(event->start)},
                      {"end_s", time(event->end)},
                      {"distance_m", event->distance_m},
                      {"energy_used_j", event->energy_used_j},
                      {"reason", event->reason}});
    }
    array.push_back({{"rover_id", outcomes.rover_id},
                     {"sequence", outcomes.sequence},
                     {"label", outcomes.label},
                     {"runs", runs}});
  }
  return array;
}

std::string to_json(const SeveralRuns& several) {
  Json runs = Json::array();
  for (std::size_t k = 0; k < several.runs.size(); ++k) {
    const Json summary = parsed(several.runs[k]);
    const LogDigest& digest =
        k == 0 ? several.with_first.front().logs[0] : several.with_first[k - 1].logs[1];
    runs.push_back({{"run", run_name(k)},
                    {"folder", several.runs[k].folder},
                    {"equal", k == 0 || several.with_first[k - 1].is_equal()},
                    {"status", at(summary, "status")},
                    {"sim_s", at(summary, "sim_s")},
                    {"log_sha256", digest.of_log},
                    {"summary_log_sha256", digest.of_summary},
                    {"rovers", at(summary, "rovers")}});
  }
  const Json document = {
      {"equal", several.are_equal()}, {"runs", runs}, {"events", events_json(several.events)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_text(const SeveralRuns& several) {
  std::string text;
  for (std::size_t k = 0; k < several.runs.size(); ++k) {
    const RunOutcome& run = several.runs[k];
    text += fmt::format("{} {}: {}{}\n", run_name(k), run.folder, status_of(run),
                        beside_first(several, k));
    const LogDigest& digest =
        k == 0 ? several.with_first.front().logs[0] : several.with_first[k - 1].logs[1];
    if (k > 0) text += other_making(several.with_first[k - 1]);
    const std::string fault = digest_fault(digest);
    if (!fault.empty()) text += fmt::format("  {}\n", fault);
  }
  text += totals(several);
  if (several.events.empty()) {
    text += "\nno event differs in status, start, end, distance or energy\n";
  } else {
    text += fmt::format("\nevents that differ from those of A; {} is as in A\n", as_first);
  }
  for (const EventOutcomes& outcomes : several.events) text += event_table(outcomes);
  return text;
}

bool ExactAgainstFirst::are_equal() const {
  return std::ranges::none_of(
      with_first, [](const ExactComparison& found) { return found.difference.has_value(); });
}

std::string to_text(const ExactAgainstFirst& exact) {
  std::string text;
  for (std::size_t k = 0; k < exact.with_first.size(); ++k) {
    const ExactComparison& found = exact.with_first[k];
    const std::string& folder = exact.folders[k + 1];
    if (!text.empty()) text += "\n";
    text += found.difference ? to_text(found, {exact.folders[0], folder})
                             : fmt::format("{}: {}", folder, to_text(found, {"", ""}));
  }
  return text;
}

std::string to_json(const ExactAgainstFirst& exact) {
  Json runs = Json::array();
  for (std::size_t k = 0; k < exact.with_first.size(); ++k) {
    Json found = Json::parse(to_json(exact.with_first[k]));
    Json run = {{"folder", exact.folders[k + 1]}};
    run.update(found);
    runs.push_back(std::move(run));
  }
  const Json document = {{"equal", exact.are_equal()}, {"first", exact.folders[0]}, {"runs", runs}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lsos
