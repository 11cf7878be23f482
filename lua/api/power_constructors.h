// Tables of what rovers and assets have besides wheels: power and shapes.
#pragma once

#include <vector>

#include "base/shape.h"
#include "lua/runtime/reader.h"
#include "power/power_spec.h"

namespace lsos {

// Reads battery, panels, loads and resources of a rover.
void read_power(TableReader& t, PowerSpec& power);
void read_panels(TableReader& t, std::vector<PanelSpec>& panels);
void read_shapes(TableReader& t, std::vector<Shape>& shapes);

}  // namespace lsos
