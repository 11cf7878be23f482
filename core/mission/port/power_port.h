// A rover's power as scripts see it: what it is now, and what they may tell it. What is asked for
// takes effect at this exchange.
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
  double sun_fraction = not_modelled, incidence = not_modelled;
  bool is_any_panel_up = false;  // false without panels
};

// What became of putting panels or antennas up or down.
struct Deployment {
  double takes_s = 0;
  bool moves = false;  // false: all are so already
};

class PowerPort {
 public:
  virtual ~PowerPort() = default;

  virtual PowerView view() const = 0;
  // With what flows now; infinite when it will not be reached so.
  virtual double time_to_charge_s(double charge) const = 0;

  // Calls the running phase when the charge is reached, however long it sleeps; until the event
  // ends.
  virtual void await_charge(double charge) = 0;

  // Sets what the battery holds, 0 to its capacity; counts as external. Throws std::runtime_error
  // for what it cannot hold, EquipmentFault without a battery.
  virtual void set_energy(double energy_j) = 0;
  // Until the event ends: external power, W, and what its work uses, W.
  virtual void set_supply(double power_w) = 0;
  virtual void set_work(double power_w) = 0;
  // Until the event ends: power from an asset, at most so much. Answers why that cannot be, "" when
  // it can.
  virtual std::string plug_into(const std::string& asset_id, std::optional<double> power_w) = 0;

  // What is left; absent when the rover carries none.
  virtual std::optional<double> resource(const std::string& name) const = 0;
  // False when there is not so much: then nothing is taken.
  virtual bool use(const std::string& name, double amount) = 0;

  // The panel with that name, "" for all. Throws std::runtime_error where no panel has the
  // name, EquipmentFault for what panels cannot do.
  virtual Deployment deploy_panel(const std::string& panel, bool up,
                                  std::optional<double> duration_s) = 0;
  virtual void steer_panel(const std::string& panel, const Steering& steering) = 0;
  // Until the last panel that turns has arrived, s; 0: none turns.
  virtual double panel_turn_left_s() const = 0;
  // Panels that have turned and do not face where they were told.
  virtual std::vector<PanelMiss> panel_misses() const = 0;
};

}  // namespace lsos
