// Energy of one rover over time: its battery, the power flows, and the sunlight last evaluated for
// its panels.
//
// Powers are constant between changes, so the energy of the battery at any time follows in closed
// form from the last change. For a rover that drives, powers change at each exchange.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "mission/port/power_port.h"
#include "mission/rover/resource_stores.h"
#include "plan/plan.h"
#include "power/power_spec.h"
#include "record/rows.h"

namespace lsos {

inline constexpr double cable_reach_m = 20;  // length of the cable
// An asset that has power to give, as rovers know it.
struct PowerSource {
  std::string asset_id;
  Vec3 p_S_m = Vec3::Zero();
};

// Sunlight on the panels when it was last evaluated; it holds until the next evaluation.
struct PanelSunlight {
  struct Panel {
    double sun_fraction = 0, cosine = 0, power_w = 0;

    void archive(Archive& a) { LSOS_ARCHIVE(a, sun_fraction, cosine, power_w); }
  };
  SimTime time{};
  bool is_dark = false;  // no sunlight falls on the rover
  std::vector<Panel> panels;
  // What the power of all panels may be less or more, W, where an estimate is not sure of the
  // horizon. An estimate is not saved.
  double less_w = 0, more_w = 0;
  bool may_be_dark = false, may_be_lit = false;  // likewise
  double ahead_s = 0;  // in an estimate: panels that turn stand as they will so long after `time`

  void archive(Archive& a) { LSOS_ARCHIVE(a, time, is_dark, panels); }
};

// How far what a rover uses, and what its battery takes, may be from what is expected, W, both at
// least 0.
struct LoadDoubt {
  double used_w = 0, stored_w = 0;
};

// What the running event has requested; it holds until the event ends.
struct PowerClaims {
  double supply_w = 0, work_w = 0;
  std::string plugged_into;  // id of an asset, "": none
  double asked_w = 0;        // requested from that asset
  std::optional<double> charge_awaited;
  bool is_short_reported = false;  // whether short supply has been reported

  void archive(Archive& a) {
    LSOS_ARCHIVE(a, supply_w, work_w, plugged_into, asked_w, charge_awaited, is_short_reported);
  }
};

class RoverPower : public PowerPort {
 public:
  // `sources` must outlive it.
  RoverPower(const PowerSpec& spec, double initial_charge, std::span<const PowerSource> sources);

  bool has_battery() const { return spec_.battery.has_value(); }
  // Requires a battery.
  double capacity_j() const { return spec_.battery->capacity_j; }
  double reserve() const { return spec_.battery->reserve; }  // charge, 0..1
  // Whether a panel or a load depends on sunlight.
  bool needs_sun() const;
  PanelArray& panels() { return panels_; }
  const PanelArray& panels() const { return panels_; }
  const std::optional<PanelSunlight>& sun() const { return sun_; }
  void set_sun(const PanelSunlight& value);
  // Sets the share 0..1 of sunlight that reaches the panels from the next exchange on: dust, a
  // cover.
  void set_shade(double share);
  // What breaks or works again: a panel that stays as it is, a share 0..1 of a panel's area that
  // gives no power, and of the capacity that the battery had at first. A panel is stuck and
  // capacity is lost at once; power of panels changes at the exchange `from`, when sunlight is
  // evaluated. Energy that the battery then cannot hold is gone; as with a level that is set, it
  // counts as external, so that what the rover used stays what it used. Requires a battery.
  void set_panel_stuck(std::size_t panel, bool is_stuck, SimTime from);
  void set_panel_lost(std::size_t panel, double share, SimTime from);
  void set_capacity_lost(double share);

  // Sets what the battery holds and how much there is of each resource as the mission begins.
  // Requires a battery for the energy.
  void begin_with(std::optional<double> energy_j, const std::map<std::string, double>& resources);

  // At the beginning of an exchange: brings the energy up to `now`. `drive_w`: mean power of the
  // wheel motors since the last exchange, 0 for a parked rover. Finds whether the battery is empty.
  void begin(SimTime now, const Vec3& p_S_m, double drive_w, bool is_parked);
  // Between two exchanges: a parked rover may move from the last exchange on. Its motors' power
  // then counts from there, not from when it was parked.
  void begin_motion() {
    if (has_battery()) begin_segment();
  }
  // At the end of an exchange: sets what flows from now on.
  void settle(bool is_parked);
  // In an estimate: what drives or limbs are expected to use from now on, absent for a rover at
  // rest. It is known beforehand, so that energy is in closed form while the rover drives.
  void set_expected_drive(std::optional<double> power_w) { expected_drive_w_ = power_w; }
  // Sets the power that the antennas use.
  void set_antennas(double power_w) { antennas_w_ = power_w; }
  // Id of the asset that the rover is plugged into; "": none.
  const std::string& plugged_into() const { return claims_.plugged_into; }
  // Power that the rover takes of an offer: what was requested, as far as it is used or fits into
  // the battery.
  double accepted_w(double offered_w, bool is_parked) const;
  // Sets the power that the asset gives.
  void set_given(double power_w) { given_w_ = power_w; }
  // Whether the battery is full.
  bool is_full() const;
  // Whether less external power comes than the event requested, though the battery has room for it.
  // Returns true once an event.
  bool take_short_supply();

  // Whether the battery was empty and its charge has not risen above the reserve since.
  bool waits_for_reserve() const { return waits_for_reserve_; }
  // Whether waits_for_reserve() has changed at this exchange.
  bool has_reserve_changed() const { return has_reserve_changed_; }
  // Whether the charge fell below the reserve and has not risen well above it since: what is left
  // is for the loads, and no drive goes on or begins. So far above, a drive does not end as it
  // begins.
  bool keeps_reserve() const { return keeps_reserve_; }
  double drives_again_at() const;  // charge, 0..1
  // Whether power may come while no event is under way: a panel is up, or there is a generator.
  bool may_charge() const { return spec_.generator_w > 0 || panels_.is_any_up(); }
  double shed_w() const;  // requested but not supplied
  // Earliest time at which a parked rover's battery becomes empty, becomes full from an asset, or
  // reaches its reserve, the charge to drive with again or the awaited charge, a panel's motion
  // ends, or a failure of a scenario takes effect.
  std::optional<SimTime> wake() const;

  double energy_at_start_j() const { return energy_at_start_j_; }
  EnergyAccount account() const;
  // Energy of loads, drives and losses since the start, and energy from panels; NaN without a
  // battery.
  double energy_used_j() const;
  double solar_j() const;
  PowerFlows flows() const;
  // In an estimate: what differs where loads are as in the dark, or as in the light, and all else
  // as it is.
  LoadDoubt load_doubt(bool is_dark, bool is_parked) const;
  // Power that comes from outside the rover, W: external power without that of its generator.
  double outside_w() const;
  double solar_available_w() const { return demand_.solar_available_w; }
  const std::map<std::string, double>& resources() const { return stores_.amounts(); }
  const PowerClaims& claims() const { return claims_; }
  // Restores the claims of the enclosing event when an event has ended; none after the outermost.
  void set_claims(const PowerClaims& claims);
  // Fills in the columns of power and energy.
  void fill(SampleRow& row) const;
  // The same for the row at time 0: nothing has flowed, and no script has set a level.
  void fill_start(SampleRow& row) const;

  PowerView view() const override;
  double time_to_charge_s(double charge) const override;
  void set_energy(double energy_j) override;
  void set_supply(double power_w) override { claims_.supply_w = power_w; }
  void set_work(double power_w) override { claims_.work_w = power_w; }
  std::string plug_into(const std::string& asset_id, std::optional<double> power_w) override;
  std::optional<double> resource(const std::string& name) const override {
    return stores_.amount(name);
  }
  bool use(const std::string& name, double amount) override { return stores_.use(name, amount); }
  double restock(const std::string& name, double amount) override {
    return stores_.restock(name, amount);
  }
  Deployment deploy_panel(const std::string& panel, bool up,
                          std::optional<double> duration_s) override;
  void steer_panel(const std::string& panel, const Steering& steering) override;
  double panel_turn_left_s() const override;
  std::vector<PanelMiss> panel_misses() const override { return panels_.misses(now_); }
  void await_charge(double charge) override { claims_.charge_awaited = charge; }
  // Whether the awaited charge has been reached at this exchange.
  bool has_reached_charge() const { return has_reached_charge_; }
  // Whether anything at this exchange may let events begin or end.
  bool has_news() const {
    return has_reserve_changed_ || has_keeping_changed_ || has_reached_charge_;
  }
  bool is_panel_turning() const { return panels_.is_turning(now_); }
  // Whether panels were commanded since sunlight was last evaluated.
  bool has_panel_command() const { return has_panel_command_; }
  void clear_panel_command() { has_panel_command_ = false; }

  void archive(Archive& a);
  bool is_sound() const;

 private:
  bool has_capacity() const { return spec_.battery->capacity_j > 0; }  // not all of it is lost
  void begin_segment();
  PowerDemand demand_now(bool is_parked) const;
  std::vector<std::size_t> panels_named(const std::string& name) const;
  double time_to_energy_s(double energy_j) const;

  PowerSpec spec_;
  std::span<const PowerSource> sources_;
  PanelArray panels_;
  SimTime now_{};
  Vec3 p_S_m_ = Vec3::Zero();
  // Present segment of constant powers.
  SimTime start_{};
  EnergyAccount at_start_;
  PowerDemand demand_;
  double energy_at_start_j_ = 0, charge_at_start_ = 0;

  std::optional<PanelSunlight> sun_;
  PowerClaims claims_;
  double antennas_w_ = 0;                   // not saved: set at each exchange
  std::optional<double> expected_drive_w_;  // not saved: estimates are not
  double given_w_ = 0;
  double sun_share_ = 1;
  std::optional<SimTime> injected_at_;  // when a failure takes effect
  std::vector<double> panels_lost_;     // share of the area that is dead, by panel
  double capacity_lost_ = 0;            // share
  double capacity_at_first_j_ = 0;      // not saved: the rover's script gives it
  bool waits_for_reserve_ = false, has_reserve_changed_ = false;
  bool keeps_reserve_ = false, has_keeping_changed_ = false;
  bool has_panel_command_ = false;
  bool has_reached_charge_ = false;
  ResourceStores stores_;
};

}  // namespace lsos
