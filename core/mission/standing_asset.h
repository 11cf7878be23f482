// An asset of the plan, on the ground.
#pragma once

#include <optional>

#include "mission/body_shape.h"
#include "mission/rover_model.h"
#include "mission/rover_power.h"
#include "terrain/ground.h"
#include "view/panel_view.h"

namespace lsos {

struct StandingAsset {
  PlanAsset plan;
  AssetModel model;
  BodyShape shape;
  PartPose pose;                // upright, looking north
  std::optional<SunValue> sun;  // of its panels, while a rover takes power

  // Its panels about `eye_S_m`, site axes: those that turn face the Sun.
  std::vector<PanelFace> panel_faces(const Vec3& eye_S_m, const Vec3& sun_S) const;
  // W, to be had now.
  double supply_w() const;
  bool gives_power() const { return model.supply_w > 0 || !model.panels.empty(); }
};

// Throws InputError: the terrain is not known there.
StandingAsset stand(const PlanAsset& asset, const AssetModel& model, const Ground& ground);

}  // namespace lsos
