// One rover's energy over time: its battery, what flows, and the sunlight that its panels were last
// seen to get.
//
// Powers are constant between changes, so that what the battery holds at any time follows in closed
// form from the last change. A rover that drives changes at each exchange.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "mission/port/power_port.h"
#include "plan/plan.h"
#include "power/power_spec.h"
#include "record/rows.h"

namespace lsos {

// An asset that has power to give, as rovers know it.
inline constexpr double plug_reach_m = 20;  // of the cable
struct PowerSource {
  std::string asset_id;
  Vec3 p_S_m = Vec3::Zero();
};

// What the Sun did for the panels when it was last looked at; held until it is looked at again.
struct SunValue {
  struct Panel {
    double sun_fraction = 0, cosine = 0, power_w = 0;

    void archive(Archive& a) { a(sun_fraction)(cosine)(power_w); }
  };
  SimTime time{};
  bool is_dark = false;  // no sunlight falls on the rover
  std::vector<Panel> panels;

  void archive(Archive& a) { a(time)(is_dark)(panels); }
};

// What an event has asked for until it ends.
struct PowerClaims {
  double supply_w = 0, work_w = 0;
  std::string plugged_into;  // of an asset
  double asked_w = 0;        // of that
  std::optional<double> charge_awaited;
  bool is_short_told = false;  // that less comes from outside than was asked for

  void archive(Archive& a) {
    a(supply_w)(work_w)(plugged_into)(asked_w)(charge_awaited)(is_short_told);
  }
};

class RoverPower : public PowerPort {
 public:
  // `sources` must outlive it.
  RoverPower(const PowerSpec& spec, double initial_charge, std::span<const PowerSource> sources);

  bool has_battery() const { return spec_.battery.has_value(); }
  // Where there is a battery.
  double capacity_j() const { return spec_.battery->capacity_j; }
  double reserve() const { return spec_.battery->reserve; }  // charge, 0..1
  // Something of it depends on the Sun.
  bool needs_sun() const;
  PanelArray& panels() { return panels_; }
  const PanelArray& panels() const { return panels_; }
  const std::optional<SunValue>& sun() const { return sun_; }
  void set_sun(const SunValue& value);
  // So much of the sunlight reaches its panels, 0..1, from the next exchange on: dust, a cover.
  void set_shade(double share);
  void set_panel_stuck(const std::string& panel, bool is_stuck);

  // At the beginning of an exchange: time has come so far, and wheel motors have used so much since
  // the last one (a rover that is parked: 0). Finds whether the battery is empty.
  void begin(SimTime now, const Vec3& p_S_m, double drive_w, bool is_parked);
  // At its end: what flows from now on.
  void settle(bool is_parked);
  // What the antennas use.
  void set_antennas(double power_w) { antennas_w_ = power_w; }
  // What the asset gives of what was asked of it.
  const std::string& plugged_into() const { return claims_.plugged_into; }
  // Of what an asset offers: as much as was asked for, is used and finds room in the battery.
  double taken_w(double offered_w, bool is_parked) const;
  void set_given(double power_w) { given_w_ = power_w; }
  // The battery takes no more than it does of what is offered to it.
  bool is_full() const;
  // Less comes from outside than the event asked for, though there is room for it in the battery.
  // True once an event.
  bool take_short();

  // The battery was empty, and its charge has not risen above the reserve since.
  bool waits_for_reserve() const { return waits_for_reserve_; }
  // That has changed at this exchange.
  bool has_reserve_changed() const { return has_reserve_changed_; }
  double shed_w() const;  // asked for, and not given
  // When a parked rover's battery gets empty, full from an asset, or reaches its reserve, a panel's
  // motion ends, or what a scenario did to it is seen.
  std::optional<SimTime> wake() const;

  double energy_at_start_j() const { return energy_at_start_j_; }
  EnergyAccount account() const;
  PowerFlows flows() const;
  double solar_available_w() const { return demand_.solar_available_w; }
  const std::map<std::string, double>& resources() const { return resources_; }
  const PowerClaims& claims() const { return claims_; }
  // An event has ended: those of the one that it was part of, or none.
  void set_claims(const PowerClaims& claims);
  // The numbers of a row.
  void fill(SampleRow& row) const;
  // Of the row at time 0: nothing has flowed, nor any script set a level.
  void fill_start(SampleRow& row) const;

  PowerView view() const override;
  double time_to_charge_s(double charge) const override;
  void set_energy(double energy_j) override;
  void set_supply(double power_w) override { claims_.supply_w = power_w; }
  void set_work(double power_w) override { claims_.work_w = power_w; }
  std::string plug_into(const std::string& asset_id, std::optional<double> power_w) override;
  std::optional<double> resource(const std::string& name) const override;
  bool use(const std::string& name, double amount) override;
  Deployment deploy_panel(const std::string& panel, bool up,
                          std::optional<double> duration_s) override;
  void steer_panel(const std::string& panel, const Steering& steering) override;
  double panel_turn_left_s() const override;
  std::vector<PanelMiss> panel_misses() const override { return panels_.misses(now_); }
  void await_charge(double charge) override { claims_.charge_awaited = charge; }
  // That has been reached at this exchange.
  bool has_reached_charge() const { return has_reached_charge_; }
  bool is_panel_turning() const { return panels_.is_turning(now_); }
  // Panels were told something since the last look at the Sun.
  bool has_panel_command() const { return has_panel_command_; }
  void clear_panel_command() { has_panel_command_ = false; }

  void archive(Archive& a);

 private:
  void begin_segment();
  PowerDemand demand_now(bool is_parked) const;
  std::vector<std::size_t> panels_named(const std::string& name) const;
  double time_to_energy_s(double energy_j) const;

  PowerSpec spec_;
  std::span<const PowerSource> sources_;
  PanelArray panels_;
  SimTime now_{};
  Vec3 p_S_m_ = Vec3::Zero();
  // The present segment.
  SimTime start_{};
  EnergyAccount at_start_;
  PowerDemand demand_;
  double energy_at_start_j_ = 0;  // of the mission; not saved, the plan says it

  std::optional<SunValue> sun_;
  PowerClaims claims_;
  double antennas_w_ = 0;  // not saved: told at each exchange
  double given_w_ = 0;
  double sun_share_ = 1;
  std::optional<SimTime> tampered_;  // what was done to panels is seen then
  bool waits_for_reserve_ = false, has_reserve_changed_ = false;
  bool has_panel_command_ = false;
  bool has_reached_charge_ = false;
  std::map<std::string, double> resources_;
};

}  // namespace lsos
