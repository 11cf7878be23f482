// Numbers that the scripts of rovers and soils have, for those who change them in proportion.
#pragma once

#include <optional>
#include <string>

#include "lua/host/catalog.h"

namespace lsos {

// The number that a rover's script gives to a key such as "battery.capacity_j" or
// "panels.Roof.efficiency", with the changes of a Variant ("" for none); absent where it gives
// none. Throws InputError where the script cannot be used.
std::optional<double> script_number(const Catalog& catalog, const std::string& rover_type,
                                    const std::string& variant, const std::string& key);

// The same of a soil: "cohesion_pa".
std::optional<double> soil_number(const Soil& soil, const std::string& key);

}  // namespace lsos
