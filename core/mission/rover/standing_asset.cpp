#include "mission/rover/standing_asset.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.h"

namespace lsos {

std::vector<PanelFace> StandingAsset::panel_faces(const Vec3& eye_S_m, const Vec3& sun_S) const {
  std::vector<PanelFace> faces;
  for (const PanelSpec& panel : model.panels) {
    const PanelPose at =
        lsos::pose(panel, facing(panel, panel.rest, pose.R_SB.transpose() * sun_S));
    faces.push_back(
        {pose.point_S_m(at.p_B_m) - eye_S_m, pose.R_SB * at.half_u_B_m, pose.R_SB * at.half_v_B_m});
  }
  return faces;
}

std::vector<Obstacle> StandingAsset::obstacles() const {
  constexpr double tall_m = 3;
  std::vector<Obstacle> obstacles;
  for (const Shape& part : model.shapes) {
    const Vec3 half_B_m = part.R_BL.cwiseAbs() * part.size_m / 2;
    if (part.p_B_m.z() - half_B_m.z() > tall_m) continue;
    obstacles.push_back(
        {plan.id, pose.point_S_m(part.p_B_m), pose.R_SB.col(0), half_B_m.head<2>()});
  }
  return obstacles;
}

double StandingAsset::supply_w() const {
  double sum_w = model.supply_w;
  if (sun) {
    for (const PanelSunlight::Panel& panel : sun->panels) sum_w += panel.power_w;
  }
  return sum_w;
}

double gap_m(const StandingAsset& asset, const Footprint& rover) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const Footprint& footprint : asset.footprints) {
    least_m = std::min(least_m, gap_m(footprint, rover));
  }
  return least_m;
}

StandingAsset place_asset(const PlanAsset& asset, const AssetModel& model, const Ground& ground) {
  const auto elevation_m = ground.elevation_m(asset.position);
  if (!elevation_m) {
    throw InputError(asset.place,
                     fmt::format("Asset '{}': the terrain is not known there", asset.id));
  }
  const SiteFrame& site = ground.site();
  PartPose pose;
  pose.p_S_m = site.p_S_m({asset.position.lon_rad, asset.position.lat_rad, *elevation_m});
  pose.R_SB.col(0) = site.north_S(pose.p_S_m);
  pose.R_SB.col(2) = site.up_S(pose.p_S_m);
  pose.R_SB.col(1) = pose.R_SB.col(2).cross(pose.R_SB.col(0));
  StandingAsset standing{asset, model, BodyShape(model.shapes), {}, pose, {}};
  for (const Obstacle& obstacle : standing.obstacles()) {
    standing.footprints.push_back(
        {obstacle.center_S_m.head<2>(), obstacle.ahead_S.head<2>().normalized(), obstacle.half_m});
  }
  return standing;
}

}  // namespace lsos
