#include "mission/estimate/day_sums.h"

#include <cmath>

#include "base/rounding.h"
#include "base/sim_time.h"

namespace lsos {

namespace {

RoverSums sums_between(const RoverSums& a, const RoverSums& b, double time_s) {
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  return {time_s, std::lerp(a.distance_m, b.distance_m, share),
          std::lerp(a.energy_used_j, b.energy_used_j, share),
          std::lerp(a.solar_j, b.solar_j, share), std::lerp(a.charge, b.charge, share)};
}

}  // namespace

void DaySums::add(const RoverSums& sums) {
  const auto end_day = [this](const RoverSums& at) {
    Day& day = days_.back();
    day.end = at;
    day.charge_min = std::fmin(day.charge_min, at.charge);
  };
  if (days_.empty()) days_.push_back({sums, sums, sums.charge});
  while (sums.time_s > day_length_s * static_cast<double>(days_.size())) {
    const RoverSums dusk =
        sums_between(days_.back().end, sums, day_length_s * static_cast<double>(days_.size()));
    end_day(dusk);
    days_.push_back({dusk, dusk, dusk.charge});
  }
  end_day(sums);
}

std::vector<DayEstimate> DaySums::days() const {
  std::vector<DayEstimate> days;
  for (const Day& day : days_) {
    DayEstimate& estimate = days.emplace_back();
    estimate.day = static_cast<int>(days.size());
    estimate.distance_m = day.end.distance_m - day.begin.distance_m;
    estimate.energy_used_j = if_known(day.end.energy_used_j - day.begin.energy_used_j);
    estimate.solar_j = if_known(day.end.solar_j - day.begin.solar_j);
    estimate.charge_min = if_known(day.charge_min);
    estimate.charge_end = if_known(day.end.charge);
  }
  return days;
}

}  // namespace lsos
