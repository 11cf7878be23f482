// An asset of the plan, on the ground.
#pragma once

#include <optional>

#include "mission/model/rover_model.h"
#include "mission/rover/body_shape.h"
#include "mission/rover/rover_power.h"
#include "route/cost/leg_request.h"
#include "terrain/ground.h"
#include "view/exposure/panel_view.h"

namespace lsos {

struct StandingAsset {
  PlanAsset plan;
  AssetModel model;
  BodyShape shape;
  std::vector<Footprint> footprints;  // obstacles() in the horizontal plane of the site frame
  PartPose pose;                      // upright, x axis to the north
  std::optional<PanelSunlight> sun;   // on its panels, while a rover takes power

  // Its panels relative to `eye_S_m`, site axes; those that turn face the Sun.
  std::vector<PanelFace> panel_faces(const Vec3& eye_S_m, const Vec3& sun_S) const;
  // Power available now, W.
  double supply_w() const;
  // Ground covered by each of its shapes that a rover would run into. Rovers drive under shapes
  // that begin higher above the ground than rovers are tall, and under panels on their masts.
  std::vector<Obstacle> obstacles() const;
  bool gives_power() const { return model.supply_w > 0 || !model.panels.empty(); }
};

// Gap between a rover's footprint (site frame) and the nearest of the asset's obstacles, as gap_m()
// of footprints; infinite when it has none.
double gap_m(const StandingAsset& asset, const Footprint& rover);

// Places an asset on the ground. Throws InputError when the terrain there is not known.
StandingAsset place_asset(const PlanAsset& asset, const AssetModel& model, const Ground& ground);

}  // namespace lsos
