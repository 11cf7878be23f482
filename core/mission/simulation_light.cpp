// Assets, sunlight, and the power that assets give to rovers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mission/ahead/ground_end_warnings.h"
#include "mission/light/sun_watch.h"
#include "mission/simulation.h"

namespace lsos {

namespace {

// Optical depth of dust on Mars when the terrain script gives none; listed among the assumptions.
constexpr double mars_optical_depth = 0.5;

}  // namespace

void Simulation::place_assets() {
  Faults faults;
  std::vector<Obstacle> standing;
  for (const PlanAsset& asset : setup_.plan.assets) {
    try {
      assets_.push_back(place_asset(asset, setup_.asset_models.at(asset.type), *ground_));
    } catch (const InputError& error) {
      faults.add(error.faults());
      continue;
    }
    if (assets_.back().gives_power()) sources_.push_back({asset.id, assets_.back().pose.p_S_m});
    const std::vector<Obstacle> more = assets_.back().obstacles();
    standing.insert(standing.end(), more.begin(), more.end());
  }
  legs_->set_standing(std::move(standing));
  faults.throw_if_errors();
}

void Simulation::make_light() {
  const bool is_wanted =
      std::ranges::any_of(rovers_, [](const Rover& r) { return r.agent->power().needs_sun(); }) ||
      std::ranges::any_of(assets_, [](const StandingAsset& a) { return !a.model.panels.empty(); });
  if (!is_wanted) return;
  renderer_ = std::make_unique<Renderer>();
  light_ = std::make_unique<Light>(*ground_, *renderer_);
  sun_over_end_ = std::make_unique<SightOverEnd>(*ground_, "the Sun");
  const bool is_dusty = ground_->site().body().air == Air::dusty;
  optical_depth_ = setup_.terrain.optical_depth.value_or(is_dusty ? mars_optical_depth : 0);
}

void Simulation::add_light_assumptions(std::vector<std::string>& assumptions) const {
  for (const auto& [type, model] : setup_.asset_models) {
    assumptions.insert(assumptions.end(), model.assumptions.begin(), model.assumptions.end());
  }
  if (!light_) return;
  const Body& body = ground_->site().body();
  if (body.air == Air::dusty && !setup_.terrain.optical_depth) {
    assumptions.push_back(
        fmt::format("Mars: dust with an optical depth of {} is assumed; a terrain script's "
                    "optical_depth says another",
                    mars_optical_depth));
  }
  if (body.air == Air::clear) {
    assumptions.push_back("Earth: a clear sky is assumed, 0.7^(air mass^0.678) of direct light");
  }
  assumptions.push_back(
      "light: panels use the Sun's direct light alone, not what air or ground "
      "scatter");
}

Motion Simulation::motion_of(const Rover& rover) const {
  const RoverPower& power = rover.agent->power();
  if (!rover.agent->is_parked() || power.is_panel_turning()) return Motion::goes_on;
  const bool has_panel_moved =
      power.has_panel_command() || power.panels().last_end(now_) == std::optional(now_);
  const bool has_mast_moved = rover.agent->antennas().has_changed(now_);
  return !rover.was_parked || has_panel_moved || has_mast_moved ? Motion::has_ended : Motion::none;
}

Motion Simulation::motion_near(const Vec3& p_S_m, const RoverAgent* except) const {
  Motion motion = Motion::none;
  for (const Rover& rover : rovers_) {
    if (rover.agent.get() == except) continue;
    if ((rover.agent->view().p_S_m - p_S_m).norm() > shading_reach_m) continue;
    motion = std::max(motion, rover.motion);
  }
  return motion;
}

// The mesh is relative to `eye_S_m`, in site axes.
Mesh Simulation::solids_near(const Vec3& eye_S_m, const std::string& except_id,
                             const Sunlight& sun) const {
  const Vec3 sun_S = direction_S(ground_->site(), eye_S_m, sun.seen);
  Mesh mesh;
  const auto is_near = [&](const Vec3& p_S_m) {
    return (p_S_m - eye_S_m).norm() < shading_reach_m;
  };
  for (const Rover& rover : rovers_) {
    if (rover.agent->id() == except_id || !is_near(rover.agent->view().p_S_m)) continue;
    append_solids(mesh, *rover.agent, eye_S_m, now_);
  }
  for (const StandingAsset& asset : assets_) {
    if (asset.plan.id == except_id || !is_near(asset.pose.p_S_m)) continue;
    append_solids(mesh, asset, eye_S_m, sun_S);
  }
  return mesh;
}

void Simulation::update_sunlight() {
  const Instant utc = setup_.plan.mission.start_time + now_;
  const bool is_whole = now_ % moving_update_period == SimTime{};
  for (Rover& rover : rovers_) {
    RoverAgent& agent = *rover.agent;
    const Vec3& p_S_m = agent.view().p_S_m;
    if (!agent.is_sun_due(now_, motion_near(p_S_m, &agent))) continue;
    const Sunlight sun = sunlight(ground_->site().body(), agent.place_now(), utc, optical_depth_);
    if (!agent.power().is_panel_turning() || is_whole) aim_panels(*ground_, agent, sun, now_);
    // Turning panels are evaluated at whole multiples of the period and when they arrive.
    if (agent.power().is_panel_turning() && !is_whole && agent.power().sun()) continue;
    const PanelSunlight value =
        evaluate_sunlight(*light_, *ground_, agent, solids_near(p_S_m, agent.id(), sun), sun, now_);
    agent.set_sun(value);
    if (value.is_dark) continue;
    const Vec3 eye_S_m = p_S_m + agent.shape().top_m() * ground_->site().up_S(p_S_m);
    sun_over_end_->add_towards(eye_S_m, direction_S(ground_->site(), p_S_m, sun.seen), sun.disc_rad,
                               agent.id(), now_);
  }
}

std::vector<Fault> Simulation::ground_end_warnings() const {
  return lsos::ground_end_warnings(machine_, *ground_, light_ != nullptr);
}

void Simulation::warn_of_ends() {
  const auto add = [&](const SightOverEnd& looks) {
    const auto warning = looks.warning(setup_.plan.mission.start_time);
    if (warning) warnings_.push_back(*warning);
  };
  if (sun_over_end_) add(*sun_over_end_);
  if (!sight_) return;
  add(sight_->earth_over_end());
  add(sight_->pairs_over_end());
}

void Simulation::share_power() {
  const Instant utc = setup_.plan.mission.start_time + now_;
  for (StandingAsset& asset : assets_) {
    const auto takes = [&](const Rover& rover) {
      return rover.agent->power().plugged_into() == asset.plan.id;
    };
    if (std::ranges::none_of(rovers_, takes)) {
      asset.sun.reset();
      continue;
    }
    const Vec3& p_S_m = asset.pose.p_S_m;
    if (!asset.model.panels.empty()) {
      const Motion motion = motion_near(p_S_m, nullptr);
      const bool is_due = !asset.sun ||
                          now_ >= asset.sun->time + sun_interval(ground_->site().body()) ||
                          motion == Motion::has_ended ||
                          (motion == Motion::goes_on && now_ % moving_update_period == SimTime{});
      if (is_due) {
        const Sunlight sun =
            sunlight(ground_->site().body(), ground_->site().geodetic(p_S_m), utc, optical_depth_);
        asset.sun = evaluate_sunlight(*light_, *ground_, asset,
                                      solids_near(p_S_m, asset.plan.id, sun), sun, now_);
        if (!asset.sun->is_dark) {
          sun_over_end_->add_towards(p_S_m + asset.shape.top_m() * ground_->site().up_S(p_S_m),
                                     direction_S(ground_->site(), p_S_m, sun.seen), sun.disc_rad,
                                     asset.plan.id, now_);
        }
      }
    }
    double left_w = asset.supply_w();
    for (Rover& rover : rovers_) {
      if (!takes(rover)) continue;
      const double given_w = rover.agent->accepted_w(left_w);
      rover.agent->power().set_given(given_w);
      left_w = std::max(0.0, left_w - given_w);
    }
  }
}

// Earliest time at which something happens to a parked rover that its scripts do not wait for.
std::optional<SimTime> Simulation::quiet_wake(const Rover& rover) const {
  std::optional<SimTime> wake = rover.agent->power().wake();
  const auto at = [&](std::optional<SimTime> time) {
    if (time) wake = std::min(wake.value_or(*time), *time);
  };
  if (light_) at(rover.agent->sun_wake(now_));
  if (sight_) at(sight_->wake());
  at(rover.agent->antennas().next_end(now_));
  for (const StandingAsset& asset : assets_) {
    if (!asset.sun || rover.agent->power().plugged_into() != asset.plan.id) continue;
    at(round_up_to_exchange(asset.sun->time + sun_interval(ground_->site().body())));
  }
  if (wake) wake = std::max(*wake, now_ + exchange_period);
  return wake;
}

}  // namespace lsos
