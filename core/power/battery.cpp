#include "power/battery.h"

#include <algorithm>

namespace lsos {

PowerFlows power_flows(const BatterySpec& battery, double energy_j, const PowerDemand& demand) {
  PowerFlows f{.solar_w = demand.solar_available_w,
               .external_w = demand.external_w,
               .load_w = demand.load_w,
               .drive_w = demand.drive_w};
  const double surplus_w = f.solar_w + f.external_w - f.load_w - f.drive_w;
  if (surplus_w >= 0) {
    const double room_w = energy_j < battery.capacity_j ? battery.charge_power_max_w : 0;
    const double charging_w = std::min(surplus_w, room_w);
    const double left_at_panel_w = std::min(surplus_w - charging_w, f.solar_w);
    f.external_w -= surplus_w - charging_w - left_at_panel_w;
    f.solar_w -= left_at_panel_w;
    f.energy_rate_w = battery.charge_efficiency * charging_w;
    f.loss_w = charging_w - f.energy_rate_w;
    return f;
  }
  const double store_w = energy_j > 0 ? battery.discharge_power_max_w : 0;
  const double discharging_w = std::min(-surplus_w, store_w);
  f.shed_w = -surplus_w - discharging_w;
  const double load_shed_w = std::min(f.shed_w, f.load_w);
  f.load_w -= load_shed_w;
  f.drive_w -= f.shed_w - load_shed_w;
  f.energy_rate_w = -discharging_w / battery.discharge_efficiency;
  f.loss_w = -f.energy_rate_w - discharging_w;
  return f;
}

double time_to_limit_s(const BatterySpec& battery, double energy_j, const PowerFlows& flows) {
  if (flows.energy_rate_w > 0) return (battery.capacity_j - energy_j) / flows.energy_rate_w;
  if (flows.energy_rate_w < 0) return energy_j / -flows.energy_rate_w;
  return std::numeric_limits<double>::infinity();
}

EnergyAccount after(const BatterySpec& battery, EnergyAccount account, const PowerDemand& demand,
                    double time_s) {
  // A full or empty battery has an energy rate of 0, so there are at most two parts.
  for (int part = 0; part < 2; ++part) {
    const PowerFlows f = power_flows(battery, account.energy_j, demand);
    const double to_limit_s = time_to_limit_s(battery, account.energy_j, f);
    const double span_s = std::min(time_s, to_limit_s);
    account.solar_j += f.solar_w * span_s;
    account.external_j += f.external_w * span_s;
    account.load_j += f.load_w * span_s;
    account.drive_j += f.drive_w * span_s;
    account.loss_j += f.loss_w * span_s;
    account.energy_j += f.energy_rate_w * span_s;
    if (time_s < to_limit_s) return account;
    account.energy_j = f.energy_rate_w > 0 ? battery.capacity_j : 0;
    time_s -= span_s;
  }
  return account;
}

EnergyAccount with_energy(EnergyAccount account, double energy_j) {
  account.external_j += energy_j - account.energy_j;
  account.energy_j = energy_j;
  return account;
}

}  // namespace lsos
