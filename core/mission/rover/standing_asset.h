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
  std::vector<Footprint> footprints;  // of obstacles(), in the horizontal plane of the site frame
  PartPose pose;                      // upright, looking north
  std::optional<SunValue> sun;        // of its panels, while a rover takes power

  // Its panels about `eye_S_m`, site axes: those that turn face the Sun.
  std::vector<PanelFace> panel_faces(const Vec3& eye_S_m, const Vec3& sun_S) const;
  // W, to be had now.
  double supply_w() const;
  // The ground that it covers: each of its shapes that a rover would run into. What begins higher
  // above the ground than rovers are tall, and panels on their masts, are driven under.
  std::vector<Obstacle> obstacles() const;
  bool gives_power() const { return model.supply_w > 0 || !model.panels.empty(); }
};

// Between what a rover covers (site frame) and the nearest of the asset's obstacles, as gap_m() of
// footprints; infinite where it has none.
double gap_m(const StandingAsset& asset, const Footprint& rover);

// Throws InputError: the terrain is not known there.
StandingAsset stand(const PlanAsset& asset, const AssetModel& model, const Ground& ground);

}  // namespace lsos
