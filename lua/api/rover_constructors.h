// What lsos.rover makes is a RoverModel, what lsos.asset makes an AssetModel. What parts share.
#pragma once

#include <optional>

#include "base/vector.h"
#include "lua/runtime/reader.h"

namespace lsos {

inline constexpr const char* rover_kind = "rover";
inline constexpr const char* asset_kind = "asset";

// A wheel's moment about its axle may hold what the drive turns behind its gear, which counts by
// the gear's ratio squared; then it is more than the other two together.
enum class MomentsOf { body, wheel };

// inertia_kgm2, with a fault where nothing can have it.
void read_moments(TableReader& t, MomentsOf of, std::optional<Vec3>& moments_kgm2, const char* doc);

}  // namespace lsos
