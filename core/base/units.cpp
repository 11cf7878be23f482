#include "base/units.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace lsos {

namespace {

constexpr double deg_rad = std::numbers::pi / 180;

// The first unit of a kind is its SI unit. ft: the international foot (1959), exactly 0.3048 m.
constexpr std::array units{
    Unit{"1", "fraction", "", 1},
    Unit{"%", "fraction", "", 0.01},
    Unit{"m", "length", "m", 1},
    Unit{"km", "length", "m", 1000},
    Unit{"cm", "length", "m", 0.01},
    Unit{"mm", "length", "m", 0.001},
    Unit{"ft", "length", "m", 0.3048},
    Unit{"m2", "area", "m2", 1},
    Unit{"cm2", "area", "m2", 1e-4},
    Unit{"m3", "volume", "m3", 1},
    Unit{"l", "volume", "m3", 1e-3},
    Unit{"m/s", "speed", "mps", 1},
    Unit{"km/h", "speed", "mps", 1 / 3.6},
    Unit{"cm/s", "speed", "mps", 0.01},
    Unit{"mm/s", "speed", "mps", 0.001},
    Unit{"m/s2", "acceleration", "mps2", 1},
    Unit{"s", "duration", "s", 1},
    Unit{"ms", "duration", "s", 0.001},
    Unit{"min", "duration", "s", 60},
    Unit{"h", "duration", "s", 3600},
    Unit{"d", "duration", "s", 86400},
    Unit{"rad", "angle", "rad", 1},
    Unit{"deg", "angle", "rad", deg_rad},
    Unit{"rad/s", "turn rate", "radps", 1},
    Unit{"deg/s", "turn rate", "radps", deg_rad},
    Unit{"kg", "mass", "kg", 1},
    Unit{"g", "mass", "kg", 0.001},
    Unit{"t", "mass", "kg", 1000},
    Unit{"kg/m3", "density", "kgpm3", 1},
    Unit{"g/cm3", "density", "kgpm3", 1000},
    Unit{"N", "force", "n", 1},
    Unit{"kN", "force", "n", 1000},
    Unit{"N m", "torque", "n_m", 1},
    Unit{"kN m", "torque", "n_m", 1000},
    Unit{"Pa", "pressure", "pa", 1},
    Unit{"kPa", "pressure", "pa", 1000},
    Unit{"MPa", "pressure", "pa", 1e6},
    Unit{"W", "power", "w", 1},
    Unit{"kW", "power", "w", 1000},
    Unit{"mW", "power", "w", 0.001},
    Unit{"J", "energy", "j", 1},
    Unit{"kJ", "energy", "j", 1000},
    Unit{"MJ", "energy", "j", 1e6},
    Unit{"Wh", "energy", "j", 3600},
    Unit{"kWh", "energy", "j", 3.6e6},
    Unit{"K", "temperature", "k", 1},
};

// The short decimal number whose reciprocal is the factor (100 for cm, 3.6 for km/h); 0 when there
// is none. Dividing by it rounds once, which makes 35 cm exactly 0.35 m.
double divisor(const Unit& unit) {
  const double short_reciprocal = std::round(1e6 / unit.si_factor) / 1e6;
  return unit.si_factor < 1 && 1 / short_reciprocal == unit.si_factor ? short_reciprocal : 0;
}

}  // namespace

const Unit* find_unit(std::string_view symbol) {
  for (const Unit& unit : units) {
    if (unit.symbol == symbol) return &unit;
  }
  return nullptr;
}

std::span<const Unit> all_units() { return units; }

double to_si(double value, const Unit& unit) {
  const double by = divisor(unit);
  return by > 0 ? value / by : value * unit.si_factor;
}

double from_si(double value_si, const Unit& unit) {
  const double by = divisor(unit);
  return by > 0 ? value_si * by : value_si / unit.si_factor;
}

}  // namespace lsos
