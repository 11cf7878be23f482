// lsos.rover makes a RoverModel, lsos.asset an AssetModel. This header has what their readers
// share.
#pragma once

#include <optional>

#include "base/vector.h"
#include "lua/runtime/reader.h"

namespace lsos {

inline constexpr const char* rover_kind = "rover";
inline constexpr const char* asset_kind = "asset";

// Kind of body that moments of inertia belong to. A wheel's moment about its axle may include what
// the drive turns behind its gear, which counts by the gear ratio squared, and may thus exceed the
// sum of the other two.
enum class MomentsOf { body, wheel };

// Reads inertia_kgm2; a fault where no such body can have these moments.
void read_moments(TableReader& t, MomentsOf of, std::optional<Vec3>& moments_kgm2, const char* doc);

}  // namespace lsos
