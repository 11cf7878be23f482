// A plan together with the rovers, assets and terrain that it names, read and checked.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "mission/model/rover_model.h"
#include "mission/model/rover_start.h"
#include "plan/plan.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

struct MissionModel {
  Plan plan;
  std::map<std::string, RoverModel> rover_models;  // by PlanRover::model()
  std::map<std::string, AssetModel> asset_models;  // by AssetType
  TerrainSpec terrain;
  std::optional<MissionStart> from;  // the run with whose end it begins; absent: none
  bool is_soil_assumed = false;      // nothing says what the ground is made of
  std::vector<std::string> assumptions;
  Faults faults;           // warnings too
  std::string plan_bytes;  // content of the plan's file when it was read; it may change meanwhile
};

}  // namespace lsos
