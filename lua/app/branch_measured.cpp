#include "lua/app/branch_measured.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

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
    nlohmann::json fields{{"age_s", seconds(last.age)},
                          {"file", file},
                          {"line", last.line},
                          {"moved_m", correction.moved_m},
                          {"turned_rad", correction.turned_rad}};
    std::string text = fmt::format("{} goes on {:.1f} m and {:.0f} deg from where it was simulated",
                                   id, correction.moved_m,
                                   std::round(degrees(correction.turned_rad)) + 0.0);  // no -0
    if (correction.charge_before) {
      fields["charge"] = power.charge;
      fields["charge_before"] = *correction.charge_before;
      text += fmt::format(", with {:.1f} % charge instead of {:.1f} %", 100 * power.charge,
                          100 * *correction.charge_before);
    }
    simulation.note_interactive(id, "measured", fields.dump());
    if (!is_quiet) print_message("{}:{}: {}\n", file, last.line, text);
  }
}

}  // namespace lsos
