#include "mission/rover/rover_power.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/error.h"
#include "mission/port/equipment_fault.h"

namespace lsos {

namespace {

constexpr double rounding = 1e-9;  // relative tolerance of comparisons

std::string stuck_text(const PanelSpec& panel) {
  return fmt::format("the panel '{}' is stuck", panel.name);
}

}  // namespace

RoverPower::RoverPower(const PowerSpec& spec, double initial_charge,
                       std::span<const PowerSource> sources)
    : spec_(spec),
      sources_(sources),
      panels_(spec.panels),
      panels_lost_(spec.panels.size(), 0.0),
      stores_(spec.resources) {
  if (spec_.battery) {
    capacity_at_first_j_ = spec_.battery->capacity_j;
    at_start_.energy_j = energy_at_start_j_ = initial_charge * spec_.battery->capacity_j;
    charge_at_start_ = energy_at_start_j_ / capacity_at_first_j_;
  }
}

void RoverPower::begin_with(std::optional<double> energy_j,
                            const std::map<std::string, double>& resources) {
  stores_.begin_with(resources);
  if (!energy_j) return;
  at_start_ = {};
  at_start_.energy_j = energy_at_start_j_ = std::min(*energy_j, capacity_j());
  charge_at_start_ = capacity_j() > 0 ? energy_at_start_j_ / capacity_j() : 0;
}

bool RoverPower::needs_sun() const {
  return !spec_.panels.empty() || std::ranges::any_of(spec_.loads, [](const LoadSpec& load) {
    return load.when == LoadState::dark;
  });
}

void RoverPower::begin(SimTime now, const Vec3& p_S_m, double drive_w, bool is_parked) {
  now_ = now;
  p_S_m_ = p_S_m;
  has_reserve_changed_ = has_reached_charge_ = has_keeping_changed_ = false;
  if (!has_battery()) return;
  if (!is_parked && !expected_drive_w_) {
    demand_.drive_w = drive_w;
    begin_segment();
  }
  const double energy_j = account().energy_j;
  // At the start nothing has been requested yet.
  const bool is_empty = now > SimTime{} && energy_j <= 0 && flows().shed_w > 0;
  // A battery that has lost all its capacity is never above a reserve: what counts is whether Sun
  // and generator suffice.
  const bool is_above = has_capacity()
                            ? energy_j > spec_.battery->reserve * spec_.battery->capacity_j
                            : flows().shed_w <= 0;
  const bool waits = waits_for_reserve_ ? !is_above : is_empty;
  has_reserve_changed_ = waits != waits_for_reserve_;
  waits_for_reserve_ = waits;
  const double least = keeps_reserve_ ? drives_again_at() : spec_.battery->reserve;
  const bool keeps = has_capacity() && energy_j < least * spec_.battery->capacity_j;
  has_keeping_changed_ = std::exchange(keeps_reserve_, keeps) != keeps;
  std::optional<double>& awaited = claims_.charge_awaited;
  has_reached_charge_ =
      awaited && has_capacity() && energy_j >= *awaited * spec_.battery->capacity_j;
  if (has_reached_charge_) awaited.reset();
}

void RoverPower::begin_segment() {
  at_start_ = account();
  start_ = now_;
}

void RoverPower::set_sun(const PanelSunlight& value) {
  sun_ = value;
  for (std::size_t i = 0; i < sun_->panels.size(); ++i) {
    sun_->panels[i].sun_fraction *= sun_share_;
    sun_->panels[i].power_w *= sun_share_ * (1 - panels_lost_[i]);
  }
}

void RoverPower::set_shade(double share) {
  sun_share_ = share;
  has_panel_command_ = true;
  injected_at_ = now_ + exchange_period;
}

PowerDemand RoverPower::demand_now(bool is_parked) const {
  PowerDemand demand;
  bool is_dark = false;
  if (sun_) {
    is_dark = sun_->is_dark;
    for (const PanelSunlight::Panel& panel : sun_->panels)
      demand.solar_available_w += panel.power_w;
  }
  demand.external_w = spec_.generator_w + claims_.supply_w + given_w_;
  demand.load_w = load_w(spec_.loads, {is_dark, is_parked}) + claims_.work_w + antennas_w_ +
                  panels_.motors_w(now_);
  demand.drive_w = is_parked ? 0 : expected_drive_w_.value_or(demand_.drive_w);
  return demand;
}

void RoverPower::settle(bool is_parked) {
  if (!has_battery()) return;
  const PowerDemand demand = demand_now(is_parked);
  // A rover that drives begins a segment at each exchange: its motors' power is known only
  // afterwards.
  if ((is_parked || expected_drive_w_) && demand == demand_) return;
  begin_segment();
  demand_ = demand;
}

EnergyAccount RoverPower::account() const {
  if (!has_battery()) return at_start_;
  return after(*spec_.battery, at_start_, demand_, seconds(now_ - start_));
}

double RoverPower::energy_used_j() const {
  if (!has_battery()) return not_modelled;
  const EnergyAccount account = this->account();
  return account.load_j + account.drive_j + account.loss_j;
}

double RoverPower::solar_j() const { return has_battery() ? account().solar_j : not_modelled; }

PowerFlows RoverPower::flows() const {
  return power_flows(*spec_.battery, account().energy_j, demand_);
}

double RoverPower::accepted_w(double offered_w, bool is_parked) const {
  offered_w = std::min(offered_w, claims_.asked_w);
  if (!has_battery()) return offered_w;
  PowerDemand demand = demand_now(is_parked);
  const double before_w = spec_.generator_w + claims_.supply_w;
  demand.external_w = before_w + offered_w;
  const double used_w = power_flows(*spec_.battery, account().energy_j, demand).external_w;
  // The margin keeps rounding errors, which scale with the largest power, from draining a full
  // battery.
  const double rounding_w = 1e-12 * demand.external_w;
  return std::clamp(used_w + rounding_w - before_w, 0.0, offered_w);
}

double RoverPower::shed_w() const { return has_battery() ? flows().shed_w : 0; }

double RoverPower::time_to_energy_s(double energy_j) const {
  const double now_j = account().energy_j, rate_w = flows().energy_rate_w;
  const double away_j = energy_j - now_j;
  if (away_j == 0) return 0;
  return rate_w != 0 && away_j / rate_w > 0 ? away_j / rate_w
                                            : std::numeric_limits<double>::infinity();
}

double RoverPower::drives_again_at() const {
  constexpr double margin = 0.05;
  const double reserve = spec_.battery->reserve;
  return reserve + std::min(margin, (1 - reserve) / 2);
}

std::optional<SimTime> RoverPower::wake() const {
  std::optional<SimTime> wake = panels_.next_end(now_);
  if (injected_at_ && *injected_at_ > now_)
    wake = std::min(wake.value_or(*injected_at_), *injected_at_);
  if (!has_battery()) return wake;
  constexpr double longest_s = 1e9;  // beyond any mission
  const auto at = [&](double in_s) {
    if (!(in_s < longest_s)) return;
    const SimTime then =
        std::max(now_ + exchange_period, round_up_to_exchange(now_ + from_seconds(in_s)));
    wake = std::min(wake.value_or(then), then);
  };
  const PowerFlows now = flows();
  if (now.energy_rate_w < 0) at(time_to_energy_s(0));
  if (!waits_for_reserve_ && now.shed_w > 0 && account().energy_j <= 0) at(0);
  if (const auto& awaited = claims_.charge_awaited; awaited && has_capacity()) {
    const bool is_passed = account().energy_j >= *awaited * spec_.battery->capacity_j;
    at(is_passed ? 0 : time_to_charge_s(*awaited));
  }
  if (!plugged_into().empty() && now.energy_rate_w > 0) {
    at(time_to_energy_s(spec_.battery->capacity_j));
  }
  if (waits_for_reserve_ && !has_capacity() && now.shed_w <= 0) at(0);
  if (waits_for_reserve_ && now.energy_rate_w > 0) {
    at(time_to_energy_s(spec_.battery->reserve * spec_.battery->capacity_j));
  }
  if (has_capacity() && spec_.battery->reserve > 0) {
    if (!keeps_reserve_ && now.energy_rate_w < 0) at(time_to_charge_s(spec_.battery->reserve));
    if (keeps_reserve_ && now.energy_rate_w > 0) at(time_to_charge_s(drives_again_at()));
  }
  return wake;
}

void RoverPower::set_claims(const PowerClaims& claims) {
  if (claims.plugged_into != claims_.plugged_into) given_w_ = 0;
  claims_ = claims;
}

void RoverPower::fill(SampleRow& row) const {
  if (sun_ && !spec_.panels.empty()) {
    double area_m2 = 0;
    row.sun_fraction = row.incidence = 0;
    for (std::size_t i = 0; i < spec_.panels.size(); ++i) {
      const double panel_m2 = spec_.panels[i].area_m2();
      const PanelSunlight::Panel& panel = sun_->panels[i];
      area_m2 += panel_m2;
      row.sun_fraction += panel.sun_fraction * panel_m2;
      row.incidence += panel.sun_fraction * std::max(0.0, panel.cosine) * panel_m2;
    }
    row.sun_fraction /= area_m2;
    row.incidence /= area_m2;
  }
  if (!has_battery()) return;
  const EnergyAccount account = this->account();
  const PowerFlows flows = this->flows();
  row.energy_j = account.energy_j;
  row.charge = spec_.battery->capacity_j > 0 ? account.energy_j / spec_.battery->capacity_j : 0;
  row.energy_rate_w = flows.energy_rate_w;
  row.solar_w = flows.solar_w;
  row.solar_available_w = demand_.solar_available_w;
  row.external_w = flows.external_w;
  row.load_w = flows.load_w;
  row.drive_w = flows.drive_w;
  row.loss_w = flows.loss_w;
  row.solar_j = account.solar_j;
  row.external_j = account.external_j;
  row.load_j = account.load_j;
  row.drive_j = account.drive_j;
  row.loss_j = account.loss_j;
}

void RoverPower::fill_start(SampleRow& row) const {
  if (!has_battery()) return;
  row.energy_j = energy_at_start_j_;
  row.charge = charge_at_start_;
  row.solar_j = row.external_j = row.load_j = row.drive_j = row.loss_j = 0;
}

PowerView RoverPower::view() const {
  SampleRow row;
  fill(row);
  PowerView view;
  view.has_battery = has_battery();
  if (has_battery()) {
    view.capacity_j = spec_.battery->capacity_j;
    view.energy_j = row.energy_j;
    view.charge = row.charge;
    view.generator_w = spec_.generator_w;
  }
  view.energy_rate_w = row.energy_rate_w;
  view.solar_w = row.solar_w;
  view.external_w = row.external_w;
  view.external_j = row.external_j;
  view.load_w = row.load_w;
  view.is_any_panel_up = panels_.is_any_up();
  view.sun_fraction = row.sun_fraction;
  view.incidence = row.incidence;
  return view;
}

double RoverPower::panel_turn_left_s() const {
  const std::optional<SimTime> end = panels_.turn_end(now_);
  if (end) return seconds(*end - now_);
  return has_panel_command_ ? seconds(exchange_period) : 0;  // it begins to turn after the scripts
}

double RoverPower::time_to_charge_s(double charge) const {
  if (!has_battery()) return std::numeric_limits<double>::infinity();
  return time_to_energy_s(charge * spec_.battery->capacity_j);
}

void RoverPower::set_energy(double energy_j) {
  if (!has_battery()) throw EquipmentFault("the rover has no battery");
  const double capacity_j = spec_.battery->capacity_j;
  if (!(energy_j >= 0 && energy_j <= capacity_j * (1 + rounding))) {
    throw std::runtime_error(
        fmt::format("{} J cannot be set: the battery holds 0 to {} J", energy_j, capacity_j));
  }
  begin_segment();
  at_start_ = with_energy(at_start_, std::min(energy_j, capacity_j));
}

bool RoverPower::is_full() const {
  return account().energy_j >= spec_.battery->capacity_j * (1 - rounding);
}

double RoverPower::outside_w() const {
  return std::max(0.0, flows().external_w - spec_.generator_w);
}

bool RoverPower::take_short_supply() {
  if (!has_battery() || claims_.is_short_reported || is_full()) return false;
  const bool is_plugged = !claims_.plugged_into.empty();
  const double asked_w = claims_.supply_w + (is_plugged ? claims_.asked_w : 0);
  const double got_w = outside_w();
  // A request for all that there is is met unless it gets nothing.
  const bool is_short = std::isfinite(asked_w) ? got_w < asked_w * (1 - rounding) : got_w <= 0;
  claims_.is_short_reported = is_short;
  return is_short;
}

std::string RoverPower::plug_into(const std::string& asset_id, std::optional<double> power_w) {
  const auto source = std::ranges::find(sources_, asset_id, &PowerSource::asset_id);
  if (source == sources_.end()) {
    return fmt::format("there is no asset '{}' with power to give", asset_id);
  }
  const double away_m = (source->p_S_m - p_S_m_).norm();
  if (away_m > cable_reach_m) {
    return fmt::format("'{}' is {:.1f} m away, farther than the {:.0f} m of a cable", asset_id,
                       away_m, cable_reach_m);
  }
  claims_.plugged_into = asset_id;
  claims_.asked_w = power_w.value_or(std::numeric_limits<double>::infinity());
  return "";
}

std::vector<std::size_t> RoverPower::panels_named(const std::string& name) const {
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < spec_.panels.size(); ++i) {
    names.push_back(spec_.panels[i].name);
    if (name.empty() || names.back() == name) found.push_back(i);
  }
  if (names.empty()) throw EquipmentFault("the rover has no solar panels");
  if (found.empty()) {
    throw std::runtime_error(fmt::format("the rover has no panel '{}'{}; it has {}", name,
                                         did_you_mean(name, names), fmt::join(names, ", ")));
  }
  return found;
}

Deployment RoverPower::deploy_panel(const std::string& name, bool up,
                                    std::optional<double> duration_s) {
  Deployment deployment;
  bool is_any = false;
  for (const std::size_t i : panels_named(name)) {
    if (!spec_.panels[i].is_stowable) {
      if (name.empty()) continue;
      throw EquipmentFault(fmt::format("the panel '{}' cannot be stowed", name));
    }
    is_any = true;
    if (panels_.is_stuck(i)) throw EquipmentFault(stuck_text(spec_.panels[i]));
    const bool is_so = panels_.is_stowed(i) != up;
    const double takes_s = panels_.deploy(i, up, duration_s, now_);
    deployment.takes_s = std::max(deployment.takes_s, takes_s);
    deployment.moves |= !is_so || takes_s > 0;
  }
  if (!is_any) throw EquipmentFault("none of the rover's panels can be stowed");
  has_panel_command_ = true;
  return deployment;
}

void RoverPower::steer_panel(const std::string& name, const Steering& steering) {
  bool is_any = false;
  for (const std::size_t i : panels_named(name)) {
    const PanelSpec& panel = spec_.panels[i];
    const std::string why = !panel.can_turn()         ? "does not turn"
                            : panels_.is_stowed(i)    ? "is stowed: it cannot be steered"
                            : !panels_.is_up(i, now_) ? "is on its way up: it cannot be steered yet"
                                                      : "";
    if (panels_.is_stuck(i)) throw EquipmentFault(stuck_text(panel));
    if (!why.empty() && !name.empty()) {
      throw EquipmentFault(fmt::format("the panel '{}' {}", panel.name, why));
    }
    if (!why.empty()) continue;
    is_any = true;
    panels_.steer(i, steering);
  }
  if (!is_any) throw EquipmentFault("none of the rover's panels can be steered now");
  has_panel_command_ = true;
}

void RoverPower::archive(Archive& a) {
  a.tag("power");
  LSOS_ARCHIVE(a, panels_, now_, p_S_m_, start_, at_start_.energy_j, at_start_.solar_j,
               at_start_.external_j, at_start_.load_j, at_start_.drive_j, at_start_.loss_j,
               demand_.solar_available_w, demand_.external_w, demand_.load_w, demand_.drive_w, sun_,
               claims_, given_w_, injected_at_, sun_share_, stores_, waits_for_reserve_,
               has_reserve_changed_, keeps_reserve_, has_keeping_changed_, has_reached_charge_,
               has_panel_command_, panels_lost_, capacity_lost_, energy_at_start_j_,
               charge_at_start_);
  if (a.is_reading() && has_battery()) {
    spec_.battery->capacity_j = capacity_at_first_j_ * (1 - capacity_lost_);
  }
}

}  // namespace lsos
