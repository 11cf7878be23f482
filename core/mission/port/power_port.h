// A rover's power as scripts see it: its state, and their commands. Commands take effect at this
// exchange.
#pragma once

#include <optional>
#include <string>

#include "base/vector.h"
#include "power/panel_array.h"

namespace lsos {

// The state at the last exchange. NaN: not modelled. Field names are those of the script API.
struct PowerView {
  bool has_battery = false;
  double energy_j = not_modelled, capacity_j = not_modelled, charge = not_modelled;
  double energy_rate_w = not_modelled, solar_w = not_modelled, external_w = not_modelled;
  double external_j = not_modelled;
  double load_w = not_modelled;
  double generator_w = not_modelled;  // made aboard whatever happens
  double sun_fraction = not_modelled, incidence = not_modelled;
  bool is_any_panel_up = false;  // false without panels
};

// Result of raising or stowing panels or antennas.
struct Deployment {
  double takes_s = 0;
  bool moves = false;  // false: all are in that position already
};

class PowerPort {
 public:
  virtual ~PowerPort() = default;

  virtual PowerView view() const = 0;
  // Time to reach a charge with the present flows, s; infinite when it will not be reached.
  virtual double time_to_charge_s(double charge) const = 0;

  // Has the running phase called when the charge is reached, however long it sleeps; until the
  // event ends.
  virtual void await_charge(double charge) = 0;

  // Sets the energy of the battery, 0 to its capacity; the change counts as external. Throws
  // std::runtime_error for an energy that it cannot hold, EquipmentFault without a battery.
  virtual void set_energy(double energy_j) = 0;
  // Set the external power and the power that the event's work uses, W, until the event ends.
  virtual void set_supply(double power_w) = 0;
  virtual void set_work(double power_w) = 0;
  // Takes power from an asset, at most `power_w`, until the event ends. Returns why that is
  // impossible, "" when it is possible.
  virtual std::string plug_into(const std::string& asset_id, std::optional<double> power_w) = 0;

  // Amount left of a resource; absent when the rover carries none.
  virtual std::optional<double> resource(const std::string& name) const = 0;
  // Uses an amount of a resource. Returns false when less is left; then nothing is taken.
  virtual bool use(const std::string& name, double amount) = 0;
  // Adds an amount of a resource, up to what there was at the start; returns what was added, 0 when
  // the rover carries none.
  virtual double restock(const std::string& name, double amount) = 0;

  // Raises, stows or steers the panel with that name, "" for all. Throws std::runtime_error when no
  // panel has the name, EquipmentFault for what panels cannot do.
  virtual Deployment deploy_panel(const std::string& panel, bool up,
                                  std::optional<double> duration_s) = 0;
  virtual void steer_panel(const std::string& panel, const Steering& steering) = 0;
  // Time until the last turning panel arrives, s; 0: none turns.
  virtual double panel_turn_left_s() const = 0;
  // Panels that have turned and do not face where they were commanded.
  virtual std::vector<PanelMiss> panel_misses() const = 0;
};

}  // namespace lsos
