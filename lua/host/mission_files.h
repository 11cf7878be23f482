// What a mission is made of, and the scripts that it was read from.
#pragma once

#include <memory>

#include "lua/host/catalog.h"
#include "mission/model/mission_model.h"

namespace lsos {

struct MissionFiles : MissionModel {
  std::shared_ptr<const Catalog> catalog;  // shared: each rebuilt script host reads it
};

}  // namespace lsos
