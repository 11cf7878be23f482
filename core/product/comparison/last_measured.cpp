#include "product/comparison/last_measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/units.h"
#include "product/comparison/text_table.h"

namespace lsos {

namespace {

constexpr SimTime old_age{60'000'000};  // older values are warned of: a rover drives on meanwhile

// The last rows at or before a moment, searched backwards.
class RowsBefore {
 public:
  RowsBefore(const Telemetry& telemetry, const std::vector<MeasuredRow>& rows, SimTime moment)
      : telemetry_(telemetry),
        rows_(rows),
        end_(std::ranges::upper_bound(rows, moment, {}, &MeasuredRow::time)) {}

  const MeasuredRow* last_place() const {
    return last([](const MeasuredRow& row) { return !std::isnan(row.lon_deg); });
  }

  // Position of a quantity in a row's values.
  std::optional<std::size_t> column(std::string_view name) const {
    const auto& all = telemetry_.quantities;
    const auto found = std::ranges::find(all, name, &MeasuredQuantity::name);
    if (found == all.end()) return {};
    return static_cast<std::size_t>(found - all.begin());
  }

  const MeasuredRow* last_with(std::initializer_list<std::optional<std::size_t>> columns) const {
    return last([&](const MeasuredRow& row) {
      return std::ranges::all_of(
          columns, [&](auto column) { return column && !std::isnan(row.values[*column]); });
    });
  }

 private:
  template <typename Predicate>
  const MeasuredRow* last(Predicate is_wanted) const {
    for (auto row = end_; row != rows_.begin();) {
      if (is_wanted(*--row)) return &*row;
    }
    return nullptr;
  }

  const Telemetry& telemetry_;
  const std::vector<MeasuredRow>& rows_;
  std::vector<MeasuredRow>::const_iterator end_;
};

// The place on the ground that has these coordinates; without z_m its height is found by iterating.
Geodetic place_at(Vec3 p_S_m, const MeasuredGround& ground) {
  if (!std::isnan(p_S_m.z())) return ground.site->geodetic(p_S_m);
  p_S_m.z() = 0;
  constexpr int iterations = 3;  // each leaves a share of |z| / R of the error
  for (int i = 0; i < iterations; ++i) {
    const Geodetic place = ground.site->geodetic(p_S_m);
    const std::optional<double> height_m = ground.height_m(place);
    if (!height_m) break;
    p_S_m.z() += *height_m - place.height_m;
  }
  return ground.site->geodetic(p_S_m);
}

std::optional<LastMeasured> last_of(const RowsBefore& rows, SimTime moment,
                                    const MeasuredGround& ground) {
  LastMeasured last;
  bool has_any = false;
  const auto take = [&](const MeasuredRow* row) {
    if (row == nullptr) return false;
    has_any = true;
    last.line = std::max(last.line, row->line);
    last.age = std::max(last.age, moment - row->time);
    return true;
  };
  const MeasuredRow* const place = rows.last_place();
  const auto x = rows.column("x_m"), y = rows.column("y_m");
  const MeasuredRow* const on_site = rows.last_with({x, y});
  // The later one counts of two kinds of places.
  if (on_site != nullptr && (place == nullptr || on_site->time > place->time)) {
    take(on_site);
    const auto z = rows.column("z_m");
    last.state.place = place_at(
        {on_site->values[*x], on_site->values[*y], z ? on_site->values[*z] : not_modelled}, ground);
  } else if (take(place)) {
    last.state.place = Geodetic{radians(place->lon_deg), radians(place->lat_deg), 0};
  }
  const auto heading = rows.column("heading_rad"), charge = rows.column("charge"),
             energy = rows.column("energy_j");
  if (const MeasuredRow* const row = rows.last_with({heading}); take(row)) {
    last.state.heading_rad = row->values[*heading];
  }
  const MeasuredRow* const with_charge = rows.last_with({charge});
  const MeasuredRow* const with_energy = rows.last_with({energy});
  if (with_energy != nullptr && (with_charge == nullptr || with_energy->time > with_charge->time)) {
    take(with_energy);
    last.state.energy_j = with_energy->values[*energy];
  } else if (take(with_charge)) {
    last.state.charge = with_charge->values[*charge];
  }
  if (!has_any) return {};
  return last;
}

}  // namespace

MeasuredStates last_measured(const Telemetry& telemetry, SimTime moment,
                             const std::vector<std::string>& rover_ids,
                             const MeasuredGround& ground) {
  MeasuredStates states;
  states.warnings = faults_of(telemetry, Severity::warning);
  const auto warn = [&](int line, std::string text) {
    states.warnings.push_back({Severity::warning, {telemetry.file, line}, std::move(text)});
  };
  for (const std::string& id : rover_ids) {
    const auto rows = telemetry.by_rover.find(id);
    const std::optional<LastMeasured> last =
        rows == telemetry.by_rover.end()
            ? std::nullopt
            : last_of(RowsBefore(telemetry, rows->second, moment), moment, ground);
    if (!last) {
      warn(0, fmt::format("has no place, heading or charge of {} up to {} of the mission: it goes "
                          "on as simulated",
                          id, clock_text(moment)));
      continue;
    }
    if (last->age > old_age) {
      warn(last->line, fmt::format("{} goes on with values measured up to {} before", id,
                                   clock_text(last->age)));
    }
    states.rovers[id] = *last;
    states.rovers[id].state.row = {telemetry.file, last->line};
  }
  if (states.rovers.empty()) {
    throw InputError({telemetry.file},
                     fmt::format("has no place, heading or charge of any rover up to {} of the "
                                 "mission; it has rows from then on only, or other columns",
                                 clock_text(moment)));
  }
  return states;
}

}  // namespace lsos
