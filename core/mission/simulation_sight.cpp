// Lines of sight between rovers, assets and Earth.
#include <algorithm>

#include "mission/light/sun_watch.h"
#include "mission/simulation.h"

namespace lsos {

namespace {

// Distance by which panels may stand out of a body's shapes.
constexpr double panels_reach_m = 10;

}  // namespace

void Simulation::make_sight() {
  const std::size_t ends = rovers_.size() + assets_.size();
  const bool is_earth_seen = ground_->site().body().name != earth_id;
  if (!setup_.keeps_sight || (ends < 2 && !is_earth_seen)) return;
  if (!renderer_) renderer_ = std::make_unique<Renderer>();
  sight_ = std::make_unique<SightWatch>(*ground_, *renderer_, ends);
}

// The ends are the rovers, then the assets.
std::vector<SightEnd> Simulation::sight_ends() const {
  std::vector<SightEnd> ends;
  for (const Rover& rover : rovers_) {
    const AntennaArray& antennas = rover.agent->antennas();
    const std::size_t in_use = antennas.in_use(now_);
    const AntennaSpec& antenna = antennas.specs()[in_use];
    ends.push_back({rover.agent->id(), rover.agent->view().p_S_m, rover.agent->antenna_S_m(),
                    antennas.has_link(in_use, now_), antenna.range_max_m, antenna.reaches_earth,
                    antennas.has_changed(now_) ? Motion::has_ended : rover.motion,
                    rover.agent->shape().reach_m(), false});
  }
  for (const StandingAsset& asset : assets_) {
    const double height_m = asset.plan.antenna_height_m.value_or(asset.model.antenna_height_m);
    ends.push_back({asset.plan.id, asset.pose.p_S_m, asset.pose.point_S_m({0, 0, height_m}), true,
                    asset.model.antenna_range_max_m, asset.model.reaches_earth, Motion::none,
                    asset.shape.reach_m(), !asset.model.panels.empty()});
  }
  return ends;
}

// Solids that may stand between two places; when the two are equal, all solids near them.
Mesh Simulation::solids_between(const Vec3& from_S_m, const Vec3& to_S_m) const {
  const Vec3 line_m = to_S_m - from_S_m;
  const double length_m = line_m.norm(), aside_m = length_m > 0 ? panels_reach_m : shading_reach_m;
  const auto is_near = [&](const Vec3& p_S_m, double reach_m) {
    const double share =
        length_m > 0 ? std::clamp((p_S_m - from_S_m).dot(line_m) / (length_m * length_m), 0.0, 1.0)
                     : 0;
    return (p_S_m - from_S_m - share * line_m).norm() < reach_m + aside_m;
  };
  Mesh mesh;
  for (const Rover& rover : rovers_) {
    if (!is_near(rover.agent->view().p_S_m, rover.agent->shape().reach_m())) continue;
    append_solids(mesh, *rover.agent, from_S_m, now_);
  }
  for (const StandingAsset& asset : assets_) {
    if (!is_near(asset.pose.p_S_m, asset.shape.reach_m())) continue;
    const SiteFrame& site = ground_->site();
    const Instant utc = setup_.plan.mission.start_time + now_;
    const Sunlight sun = sunlight(site.body(), site.geodetic(asset.pose.p_S_m), utc, 0);
    append_solids(mesh, asset, from_S_m, direction_S(site, asset.pose.p_S_m, sun.seen));
  }
  return mesh;
}

void Simulation::update_sight() {
  const Instant utc = setup_.plan.mission.start_time + now_;
  const auto ended = sight_->look(
      now_, utc, sight_ends(),
      [&](const Vec3& from_S_m, const Vec3& to_S_m) { return solids_between(from_S_m, to_S_m); });
  if (log_ == nullptr) return;
  for (const SightIntervalRow& row : ended) log_->write(row);
}

void Simulation::log_pairs(std::size_t from) {
  const Instant utc = setup_.plan.mission.start_time + now_;
  for (const PairRow& row : sight_->rows(now_, utc, sight_ends(), from)) log_->write(row);
}

void Simulation::finish_sight() {
  for (const SightIntervalRow& row : sight_->finish(now_, sight_ends())) log_->write(row);
}

}  // namespace lsos
