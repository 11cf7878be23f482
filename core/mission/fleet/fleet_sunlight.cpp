#include "mission/fleet/fleet_sunlight.h"

#include <fmt/format.h>

#include <algorithm>

#include "mission/fleet/solids.h"

namespace lsos {

namespace {

// What panels get besides direct light.
std::string diffuse_light_assumption(const Body& body, double optical_depth, double albedo) {
  const std::string ground = fmt::format("ground of albedo {}", albedo);
  if (body.air == Air::clear) {
    return fmt::format("diffuse light: clear sky (Liu and Jordan 1960), {}; no twilight", ground);
  }
  if (optical_depth > 0) {
    return fmt::format(
        "diffuse light: two-stream, optical depth {}, Viking's dust (Pollack et al. 1979), {}; no "
        "twilight",
        optical_depth, ground);
  }
  if (albedo > 0) {
    return fmt::format("diffuse light: {} alone, as if all of it were lit; no sky", ground);
  }
  return "light: panels use the Sun's direct light alone, not what air or ground scatter";
}

// Half of the time for which what an estimate finds of panels that turn holds.
SimTime half_way_ahead(const PanelArray& panels, SimTime now) {
  const SimTime whole = (now / estimate_turn_period + 1) * estimate_turn_period;
  return (std::min(whole, panels.next_end(now).value_or(whole)) - now) / 2;
}

}  // namespace

FleetSunlight::FleetSunlight(const Ground& ground, Renderer& renderer,
                             std::optional<double> optical_depth, std::optional<double> albedo,
                             bool is_estimate)
    : ground_(&ground),
      light_(ground, renderer, is_estimate),
      over_end_(ground, "the Sun"),
      optical_depth_(optical_depth.value_or(body().assumed_optical_depth)),
      albedo_(albedo.value_or(body().assumed_albedo)),
      is_depth_assumed_(body().air == Air::dusty && !optical_depth),
      is_estimate_(is_estimate) {}

std::vector<std::string> FleetSunlight::assumptions() const {
  std::vector<std::string> assumptions;
  if (is_depth_assumed_) {
    assumptions.push_back(
        fmt::format("Mars: dust with an optical depth of {} is assumed; a terrain script's "
                    "optical_depth says another",
                    optical_depth_));
  }
  if (body().air == Air::clear) {
    assumptions.push_back("Earth: a clear sky is assumed, 0.7^(air mass^0.678) of direct light");
  }
  assumptions.push_back(diffuse_light_assumption(body(), optical_depth_, albedo_));
  return assumptions;
}

Sunlight FleetSunlight::sunlight_at(const Geodetic& place, const Moment& moment) const {
  return sunlight(body(), place, moment.utc, optical_depth_, albedo_);
}

// The Sun has moved far enough; the rover or something near it moves, at whole multiples of the
// period; or motion has just ended.
bool FleetSunlight::is_due(const RoverAgent& rover, SimTime now, Motion near) const {
  const RoverPower& power = rover.power();
  if (!power.needs_sun()) return false;
  const std::optional<PanelSunlight>& sun = power.sun();
  if (!sun || now >= sun->time + interval()) return true;
  if (near == Motion::has_ended) return true;
  const bool moves = !rover.is_parked() || near == Motion::goes_on || follows_turns(rover);
  if (moves && now > sun->time && now % turn_period() == SimTime{}) return true;
  const std::optional<SimTime> motion_end = power.panels().last_end(now);
  return rover.drive().has_motion_ended() || power.has_panel_command() ||
         (motion_end && *motion_end > sun->time);
}

bool FleetSunlight::is_due(const StandingAsset& asset, SimTime now, Motion near) const {
  return !asset.sun || now >= asset.sun->time + interval() || near == Motion::has_ended ||
         (near == Motion::goes_on && now % turn_period() == SimTime{});
}

void FleetSunlight::update(Fleet& fleet, const Moment& moment) {
  const SimTime now = moment.now;
  const SiteFrame& site = ground_->site();
  const bool is_whole = now % turn_period() == SimTime{};
  for (FleetRover& rover : fleet.rovers) {
    RoverAgent& agent = *rover.agent;
    const Vec3& p_S_m = agent.view().p_S_m;
    if (!is_due(agent, now, motion_near(fleet, p_S_m, &agent))) continue;
    const Sunlight sun = sunlight_at(agent.motion().place(), moment);
    if (!follows_turns(agent) || is_whole) aim_panels(*ground_, agent, sun, now);
    const bool turns = follows_turns(agent);
    // Turning panels are evaluated at whole multiples of the period and when they arrive; in an
    // estimate also as they set off, and as they stand in the middle of the time until the next.
    if (turns && !is_whole && agent.power().sun() && !is_estimate_) continue;
    const SimTime ahead =
        turns && is_estimate_ ? half_way_ahead(agent.power().panels(), now) : SimTime{};
    const SimTime seen_at = now + ahead;
    PanelSunlight value =
        evaluate_sunlight(light_, *ground_, agent,
                          solids_near(fleet, site, p_S_m, agent.id(), sun, now), sun, seen_at);
    value.time = now;
    value.ahead_s = seconds(ahead);
    agent.power().set_sun(value);
    agent.power().clear_panel_command();
    agent.drive().clear_motion_ended();
    if (value.is_dark) continue;
    const Vec3 eye_S_m = p_S_m + agent.shape().top_m() * site.up_S(p_S_m);
    over_end_.add_towards(eye_S_m, direction_S(site, p_S_m, sun.seen), sun.disc_rad, agent.id(),
                          now);
  }
}

void FleetSunlight::update(StandingAsset& asset, const Fleet& fleet, const Moment& moment) {
  const SimTime now = moment.now;
  const SiteFrame& site = ground_->site();
  const Vec3& p_S_m = asset.pose.p_S_m;
  if (!is_due(asset, now, motion_near(fleet, p_S_m, nullptr))) return;
  const Sunlight sun = sunlight_at(site.geodetic(p_S_m), moment);
  asset.sun = evaluate_sunlight(light_, *ground_, asset,
                                solids_near(fleet, site, p_S_m, asset.plan.id, sun, now), sun, now);
  if (asset.sun->is_dark) return;
  over_end_.add_towards(p_S_m + asset.shape.top_m() * site.up_S(p_S_m),
                        direction_S(site, p_S_m, sun.seen), sun.disc_rad, asset.plan.id, now);
}

std::optional<SimTime> FleetSunlight::wake(const RoverAgent& rover, const Fleet& fleet,
                                           SimTime now) const {
  std::optional<SimTime> wake;
  const RoverPower& power = rover.power();
  if (power.needs_sun() && power.sun()) {
    // Turning panels are also evaluated when they arrive, which RoverPower::wake() covers.
    wake = follows_turns(rover) ? (now / turn_period() + 1) * turn_period()
                                : round_up_to_exchange(power.sun()->time + interval());
  }
  for (const StandingAsset& asset : fleet.assets) {
    if (!asset.sun || power.plugged_into() != asset.plan.id) continue;
    const SimTime due = round_up_to_exchange(asset.sun->time + interval());
    wake = std::min(wake.value_or(due), due);
  }
  return wake;
}

}  // namespace lsos
