// Text of a summary's quantities in the units of the report: m and km, s to h, Wh and kWh, W and
// kW, degrees, per cent.
#pragma once

#include <string>

namespace lsos {

// The name without its unit: "energy_used_j" becomes "energy used".
std::string quantity_label(const std::string& name);

// The suffix of `name` gives the unit of `value`: distance_m, solar_j, max_slip. `digits`: that
// many are significant.
std::string quantity_text(const std::string& name, double value, int digits = 6);
// The same for a difference, with its sign.
std::string change_text(const std::string& name, double change, int digits = 6);

}  // namespace lsos
