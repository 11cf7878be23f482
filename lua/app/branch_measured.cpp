#include "lua/app/branch_measured.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/console.h"
#include "base/files.h"
#include "base/units.h"
#include "mission/model/mission_span.h"
#include "mission/simulation.h"

namespace lsos {

MeasuredStates read_measured(const std::string& file, const LogReader& log, SimTime moment,
                             const SiteFrame& site) {
  const std::optional<std::string> text = read_file(file);
  if (!text) throw InputError({file}, "no such file, or it cannot be read");
  // Rows after the run's end are of no use to a branch, but no fault.
  RunExtent extent{log.start(), longest_mission, {}};
  for (const auto& [id, totals] : log.sample_totals()) extent.rovers.push_back(id);
  return last_measured(read_telemetry(file, *text, extent), moment, extent.rovers, site);
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
    std::vector<std::string> changes;
    if (last.state.place) {
      fields["moved_m"] = correction.moved_m;
      changes.push_back(fmt::format("{:.1f} m from where it was simulated", correction.moved_m));
    }
    if (last.state.heading_rad) {
      fields["turned_rad"] = correction.turned_rad;
      const double turned_deg = std::round(degrees(correction.turned_rad)) + 0.0;  // no -0
      changes.push_back(fmt::format("turned by {:.0f} deg", turned_deg));
    }
    if (correction.stopped_mps > 0) {
      fields["stopped_mps"] = correction.stopped_mps;
      changes.push_back(
          fmt::format("from rest, where it drove at {:.2f} m/s", correction.stopped_mps));
    }
    if (correction.charge_before) {
      fields["charge"] = power.charge;
      fields["charge_before"] = *correction.charge_before;
      changes.push_back(fmt::format("with {:.2f} % charge instead of {:.2f} %", 100 * power.charge,
                                    100 * *correction.charge_before));
    }
    const std::string text = fmt::format("{} goes on {}", id, fmt::join(changes, ", "));
    simulation.note_interactive(id, "measured", fields.dump());
    if (!is_quiet) print_message("{}:{}: {}\n", file, last.line, text);
  }
}

}  // namespace lsos
