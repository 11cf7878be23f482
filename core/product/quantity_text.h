// Quantities of a summary as people read them, in the units of the report: m and km, s to h, Wh and
// kWh, degrees, per cent.
#pragma once

#include <string>

namespace lsos {

// "energy_used_j" is "energy used".
std::string quantity_label(const std::string& name);

// `name` says the unit of `value`: distance_m, solar_j, max_slip. Six digits that count.
std::string quantity_text(const std::string& name, double value);
// The same of a difference, with its sign.
std::string change_text(const std::string& name, double change);

}  // namespace lsos
