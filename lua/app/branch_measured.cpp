#include "lua/app/branch_measured.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/bounded_file.h"
#include "base/console.h"
#include "base/units.h"
#include "mission/model/mission_span.h"
#include "mission/simulation.h"

namespace lsos {

MeasuredStates read_measured(const std::string& file, const LogReader& log, SimTime moment,
                             const Ground& ground) {
  const std::string text = read_named_file(file);
  // Rows after the run's end are of no use to a branch, but no fault.
  RunExtent extent{log.start(), longest_mission, {}};
  for (const auto& [id, totals] : log.sample_totals()) extent.rovers.push_back(id);
  const auto height_m = [&](const Geodetic& place) { return ground.elevation_m(place); };
  return last_measured(read_telemetry(file, text, extent), moment, extent.rovers,
                       {&ground.site(), height_m});
}

void go_on_from_measured(Simulation& simulation, const MeasuredStates& measured,
                         const std::string& file, bool is_quiet) {
  std::map<std::string, MeasuredState> states;
  for (const auto& [id, last] : measured.rovers) states[id] = last.state;
  const auto corrections = simulation.correct(states);
  for (const auto& [id, correction] : corrections) {
    const LastMeasured& last = measured.rovers.at(id);
    const PowerView power = simulation.fleet().find(id)->agent->power().view();
    nlohmann::json fields{{"age_s", seconds(last.age)}, {"file", file}, {"line", last.line}};
    // Changes that would be written as none are left out.
    std::vector<std::string> changes;
    const auto add = [&](bool is_seen, std::string text) {
      if (is_seen) changes.push_back(std::move(text));
    };
    if (last.state.place) {
      fields["moved_m"] = correction.moved_m;
      add(correction.moved_m >= 0.05,
          fmt::format("{:.1f} m from where it was simulated", correction.moved_m));
    }
    if (last.state.heading_rad) {
      fields["turned_rad"] = correction.turned_rad;
      const double turned_deg = std::round(degrees(correction.turned_rad)) + 0.0;  // no -0
      add(turned_deg != 0, fmt::format("turned by {:.0f} deg", turned_deg));
    }
    if (correction.stopped_mps > 0) {
      fields["stopped_mps"] = correction.stopped_mps;
      changes.push_back(
          fmt::format("from rest, where it drove at {:.2f} m/s", correction.stopped_mps));
    }
    if (correction.charge_before) {
      fields["charge"] = power.charge;
      fields["charge_before"] = *correction.charge_before;
      add(std::abs(power.charge - *correction.charge_before) >= 5e-5,
          fmt::format("with {:.2f} % charge instead of {:.2f} %", 100 * power.charge,
                      100 * *correction.charge_before));
    }
    if (changes.empty()) changes.emplace_back("as it was simulated");
    const std::string text = fmt::format("{} goes on {}", id, fmt::join(changes, ", "));
    simulation.note_interactive(
        id, "measured", fields.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    if (!is_quiet) print_message("{}:{}: {}\n", file, last.line, text);
  }
}

}  // namespace lsos
