// Energy and sunlight of a rover.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mission/port/note_json.h"
#include "mission/rover/rover_agent.h"
#include "planet/sunlight.h"

namespace lsos {

void RoverAgent::update_energy(SimTime now) {
  now_ = now;
  power_.begin(now, view_.p_S_m, view_.drive_w, is_parked_);
  warn_of_low_charge(now);
  if (!power_.has_reserve_changed() || !power_.waits_for_reserve()) return;
  noting_sequence_ = 0;
  note("battery_empty", fmt::format(R"({{"shed_w":{}}})", note_json(power_.shed_w())));
  if (!std::exchange(has_warned_of_empty_, true)) {
    warnings_.push_back(fmt::format(
        "{}: the battery is empty at {} s, and {:.0f} W are shed; what drives or works fails, and "
        "what comes later waits until its charge is above the reserve",
        rover_.id, seconds(now), power_.shed_w()));
  }
  if (is_driving()) {
    drive_failure_ = "the battery is empty";
    command_ = {};
    has_new_command_ = true;
  }
}

// Planners count on the reserve, so a charge below it is reported long before the battery is empty.
void RoverAgent::warn_of_low_charge(SimTime now) {
  if (has_warned_of_low_ || !power_.has_battery()) return;
  const double charge = power_.account().energy_j / power_.capacity_j();
  if (!(charge < power_.reserve())) return;
  has_warned_of_low_ = true;
  warnings_.push_back(
      fmt::format("{}: at {} s its charge is {:.1f} %, below the reserve of {:.0f} %", rover_.id,
                  seconds(now), 100 * charge, 100 * power_.reserve()));
}

void RoverAgent::update_flows() {
  power_.set_antennas(antennas_.power_w(now_));
  power_.settle(is_parked_);
}

double RoverAgent::accepted_w(double offered_w) {
  power_.set_antennas(antennas_.power_w(now_));
  return power_.accepted_w(offered_w, is_parked_);
}

// update_energy() reports an empty battery.
void RoverAgent::warn_of_shed_loads(double shed_w) {
  if (has_warned_of_shed_ || !(power_.account().energy_j > 0)) return;
  has_warned_of_shed_ = true;
  warn(fmt::format(
      "{}: at {} s its loads and motors ask {:.0f} W more than its battery gives; events go on "
      "as if they had them, and the energy is not counted",
      rover_.id, seconds(now_), shed_w));
}

void RoverAgent::report_short_supply() {
  if (!power_.take_short_supply()) return;
  const PowerClaims& claims = power_.claims();
  const double got_w = power_.flows().external_w;
  const bool is_plugged = !claims.plugged_into.empty();
  const double asked_w = claims.supply_w + (is_plugged ? claims.asked_w : 0);
  note("supply_short",
       fmt::format(R"({{"asked_w":{},"given_w":{}}})",
                   note_json(std::isfinite(asked_w) ? asked_w : not_modelled), note_json(got_w)));
  const std::string from = is_plugged ? fmt::format("'{}'", claims.plugged_into) : "outside";
  if (!std::isfinite(asked_w)) {
    warn(fmt::format("{}: at {} s {} has no power left to give", rover_.id, seconds(now_), from));
    return;
  }
  warn(fmt::format("{}: at {} s {:.0f} W come from {}, {:.0f} W are requested", rover_.id,
                   seconds(now_), got_w, from, asked_w));
}

void RoverAgent::settle_energy() {
  update_flows();
  report_short_supply();
  const double shed_w = power_.shed_w();
  if ((shed_w > 0) == is_shedding_) return;
  is_shedding_ = shed_w > 0;
  noting_sequence_ = 0;
  if (is_shedding_) {
    warn_of_shed_loads(shed_w);
    note("loads_shed", fmt::format(R"({{"shed_w":{}}})", note_json(shed_w)));
  } else {
    note("loads_restored", "{}");
  }
}

bool RoverAgent::is_sun_due(SimTime now, Motion near) const {
  if (!power_.needs_sun()) return false;
  const std::optional<PanelSunlight>& sun = power_.sun();
  if (!sun || now >= sun->time + sun_interval(ground_->site().body())) return true;
  if (near == Motion::has_ended) return true;
  const bool moves = !is_parked_ || near == Motion::goes_on || power_.is_panel_turning();
  if (moves && now > sun->time && now % moving_update_period == SimTime{}) return true;
  const std::optional<SimTime> motion_end = power_.panels().last_end(now);
  return has_motion_ended_ || power_.has_panel_command() || (motion_end && *motion_end > sun->time);
}

std::optional<SimTime> RoverAgent::sun_wake(SimTime now) const {
  const std::optional<PanelSunlight>& sun = power_.sun();
  if (!power_.needs_sun() || !sun) return {};
  // Turning panels are also evaluated when they arrive, which RoverPower::wake() covers.
  if (power_.is_panel_turning()) return (now / moving_update_period + 1) * moving_update_period;
  return round_up_to_exchange(sun->time + sun_interval(ground_->site().body()));
}

void RoverAgent::set_sun(const PanelSunlight& value) {
  power_.set_sun(value);
  power_.clear_panel_command();
  has_motion_ended_ = false;
}

double RoverAgent::energy_used_j() const {
  if (!power_.has_battery()) return not_modelled;
  const EnergyAccount account = power_.account();
  return account.load_j + account.drive_j + account.loss_j;
}

double RoverAgent::solar_j() const {
  return power_.has_battery() ? power_.account().solar_j : not_modelled;
}

std::vector<PanelRow> RoverAgent::panels(SimTime now) const {
  std::vector<PanelRow> rows;
  const std::optional<PanelSunlight>& sun = power_.sun();
  const PanelArray& panels = power_.panels();
  const Mat3 R_SB = power_.panels().specs().empty() ? Mat3::Identity() : part_poses()[0].R_SB;
  for (std::size_t i = 0; i < panels.specs().size(); ++i) {
    PanelRow row{.time = now, .rover_id = rover_.id, .panel = panels.specs()[i].name};
    if (sun) {
      const PanelSunlight::Panel& lit = sun->panels[i];
      row.sun_fraction = lit.sun_fraction;
      row.incidence = lit.sun_fraction * std::max(0.0, lit.cosine);
      row.power_w = lit.power_w;
    }
    if (panels.is_up(i, now)) {
      const SiteFrame& site = ground_->site();
      const Vec3 normal_S = R_SB * panels.pose_at(i, now).normal_B();
      const double east = normal_S.dot(site.east_S(report_.p_S_m));
      const double north = normal_S.dot(site.north_S(report_.p_S_m));
      const double azimuth_rad = std::atan2(east, north);
      row.azimuth_rad = azimuth_rad < 0 ? azimuth_rad + 2 * std::numbers::pi : azimuth_rad;
      row.elevation_rad =
          std::atan2(normal_S.dot(site.up_S(report_.p_S_m)), std::hypot(east, north));
    }
    rows.push_back(row);
  }
  return rows;
}

std::vector<ResourceRow> RoverAgent::resources(SimTime now) const {
  std::vector<ResourceRow> rows;
  for (const auto& [name, amount] : power_.resources()) {
    rows.push_back({now, rover_.id, name, amount});
  }
  return rows;
}

}  // namespace lsos
