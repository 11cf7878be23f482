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
  double load_w = not_modelled;
  double sun_fraction = not_modelled, incidence = not_modelled;
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

  // Sets what the battery holds, at most its capacity; counts as external. Throws EquipmentFault
  // without a battery.
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

  // Of the panel with that name, "" for all. Answers how long that takes, s. Throws
  // std::runtime_error where no panel has the name, EquipmentFault for what panels cannot do.
  virtual double deploy_panel(const std::string& panel, bool up,
                              std::optional<double> duration_s) = 0;
  virtual void steer_panel(const std::string& panel, const Steering& steering) = 0;
  // Until the last panel that turns has arrived, s; 0: none turns.
  virtual double panel_turn_left_s() const = 0;
};

}  // namespace lsos
