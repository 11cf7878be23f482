// A battery on a bus: what flows, and how its charge follows. Powers are constant over a time that
// the caller chooses; everything between is in closed form.
#pragma once

#include <limits>

namespace lsos {

struct BatterySpec {
  double capacity_j = 0;
  double charge_efficiency = 1;     // of what goes in, the share that is kept, 0..1
  double discharge_efficiency = 1;  // of what is taken out, the share that reaches the bus, 0..1
  double charge_power_max_w = std::numeric_limits<double>::infinity();     // at the bus
  double discharge_power_max_w = std::numeric_limits<double>::infinity();  // at the bus
  double reserve = 0;  // charge 0..1 above which a mission goes on after the battery was empty
};

// What is offered and asked for, W, none below 0.
struct PowerDemand {
  double solar_available_w = 0;
  double external_w = 0;
  double load_w = 0;
  double drive_w = 0;

  bool operator==(const PowerDemand&) const = default;
};

// What flows, W: energy_rate_w = solar_w + external_w - load_w - drive_w - loss_w. Solar power
// beyond what is used and stored is left at the panel, then external power at its source. What
// cannot be met is shed: loads first, then drives.
struct PowerFlows {
  double solar_w = 0;
  double external_w = 0;
  double load_w = 0;
  double drive_w = 0;
  double loss_w = 0;  // in charging and discharging
  double energy_rate_w = 0;
  double shed_w = 0;  // asked for, and not given
};
PowerFlows power_flows(const BatterySpec& battery, double energy_j, const PowerDemand& demand);

// What the battery holds, and what has flowed since the start.
struct EnergyAccount {
  double energy_j = 0;
  double solar_j = 0;
  double external_j = 0;
  double load_j = 0;
  double drive_j = 0;
  double loss_j = 0;
};

// When these flows fill or empty the battery, s; infinite if they do not.
double time_to_limit_s(const BatterySpec& battery, double energy_j, const PowerFlows& flows);

// The account after a time of constant demand: exact, also where the battery gets full or empty on
// the way. `time_s` >= 0.
EnergyAccount after(const BatterySpec& battery, EnergyAccount account, const PowerDemand& demand,
                    double time_s);

// Sets what the battery holds at once; what that takes or gives counts as external.
EnergyAccount with_energy(EnergyAccount account, double energy_j);

}  // namespace lsos
