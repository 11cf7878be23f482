// A battery on a bus: power flows, and its charge over time. Powers are constant over a time span
// that the caller chooses; the charge within it is computed in closed form.
#pragma once

#include <limits>

namespace lsos {

struct BatterySpec {
  double capacity_j = 0;
  double charge_efficiency = 1;     // share of the energy put in that is stored, 0..1
  double discharge_efficiency = 1;  // share of the energy taken out that reaches the bus, 0..1
  double charge_power_max_w = std::numeric_limits<double>::infinity();     // at the bus
  double discharge_power_max_w = std::numeric_limits<double>::infinity();  // at the bus
  // Charge 0..1 that is kept for loads: no drive goes on below it, and after the battery was empty
  // work goes on above it.
  double reserve = 0;
};

// Power offered and requested, W, each at least 0.
struct PowerDemand {
  double solar_available_w = 0;
  double external_w = 0;
  double load_w = 0;
  double drive_w = 0;

  bool operator==(const PowerDemand&) const = default;
};

// Power flows, W: energy_rate_w = solar_w + external_w - load_w - drive_w - loss_w. A surplus
// beyond what is used and stored is left unused: solar power first, then external power. A deficit
// is shed: loads first, then drives.
struct PowerFlows {
  double solar_w = 0;
  double external_w = 0;
  double load_w = 0;
  double drive_w = 0;
  double loss_w = 0;  // in charging and discharging
  double energy_rate_w = 0;
  double shed_w = 0;  // requested but not supplied
};
PowerFlows power_flows(const BatterySpec& battery, double energy_j, const PowerDemand& demand);

// Energy in the battery, and energies that have flowed since the start.
struct EnergyAccount {
  double energy_j = 0;
  double solar_j = 0;
  double external_j = 0;
  double load_j = 0;
  double drive_j = 0;
  double loss_j = 0;
};

// Time until these flows fill or empty the battery, s; infinite if they do not.
double time_to_limit_s(const BatterySpec& battery, double energy_j, const PowerFlows& flows);

// The account after a time span of constant demand: exact, even where the battery becomes full or
// empty within it. `time_s` >= 0.
EnergyAccount after(const BatterySpec& battery, EnergyAccount account, const PowerDemand& demand,
                    double time_s);

// Sets the battery's energy at once; the difference counts as external energy.
EnergyAccount with_energy(EnergyAccount account, double energy_j);

}  // namespace lsos
