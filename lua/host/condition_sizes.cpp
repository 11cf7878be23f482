#include "lua/host/condition_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "lua/host/condition_comparisons.h"

namespace lsos {

namespace {

bool is_outside(const SingleComparison& c) {
  return c.number < c.bounds.low || c.number > c.bounds.high;
}

bool never_holds(const SingleComparison& c) {
  if (c.how == "<") return c.number <= c.bounds.low;
  if (c.how == ">") return c.number >= c.bounds.high;
  if (c.how == "<=") return c.number < c.bounds.low;
  if (c.how == ">=") return c.number > c.bounds.high;
  return c.how == "==" && is_outside(c);
}

std::string never_text(const SingleComparison& c, const std::string& why) {
  return fmt::format("'{} {} {:g}' never holds: {}", c.shown, c.how, c.number, why);
}

std::string bounds_text(const SingleComparison& c) {
  if (std::isinf(c.bounds.high)) return fmt::format("{} is {:g} at least", c.shown, c.bounds.low);
  if (std::isinf(c.bounds.low)) return fmt::format("{} is {:g} at most", c.shown, c.bounds.high);
  return fmt::format("{} is from {:.4g} to {:.4g}", c.shown, c.bounds.low, c.bounds.high);
}

// Doubt about an energy that seems to be in kWh or a speed that seems to be in km/h. Only the
// rover's own capacity and greatest speed distinguish these from SI values.
std::string scale_fault(const SingleComparison& c, const ConditionWorld& world) {
  constexpr double overspeed = 1.5, j_per_kwh = 3.6e6, kmh_per_mps = 3.6;
  // Comparisons with 0 or 1 J are for an empty battery.
  if (c.quantity == "energy_j" && world.battery_capacity_j && c.number > 1 &&
      c.number * j_per_kwh <= 1.1 * *world.battery_capacity_j) {
    return fmt::format(
        "energy_j is in J, and is compared with {0:g}, where the battery holds "
        "{1:.3g}: {0:g} kWh is {0:g} * 3.6e6",
        c.number, *world.battery_capacity_j);
  }
  if (c.quantity == "speed_mps" && world.speed_max_mps &&
      c.number > overspeed * *world.speed_max_mps &&
      c.number <= kmh_per_mps * overspeed * *world.speed_max_mps) {
    return fmt::format(
        "speed_mps is in m/s, and is compared with {0:g}, where the rover does "
        "{1:.3g} at most: {0:g} km/h is {0:g} / 3.6",
        c.number, *world.speed_max_mps);
  }
  return "";
}

// Doubt about a time that seems to be in hours, judged by its size. `is_alone`: together with
// another comparison the first seconds of a mission may well be meant.
std::string hours_doubt(const SingleComparison& c, bool is_alone) {
  constexpr double hours_max = 25;
  if (c.quantity != "time_s" || c.how == "==" || c.number <= 0 || c.number >= hours_max) return "";
  if (!is_alone) return "";
  return fmt::format(
      "time_s is in s since the mission's start, and is compared with {0:g}: {0:g} h "
      "is {0:g} * 3600",
      c.number);
}

// Doubt about a comparison that holds only after the mission's end.
std::string late_doubt(const SingleComparison& c, const ConditionWorld& world, bool is_alone) {
  if (c.quantity != "time_s" || !is_alone || !world.max_duration_s) return "";
  SingleComparison within = c;
  within.bounds = {0, *world.max_duration_s};
  if (!never_holds(within)) return "";
  return never_text(c, fmt::format("MaxDuration is {:g} s", *world.max_duration_s));
}

// Doubt about a latitude or longitude whose sign seems to be missing: the whole plan lies about its
// negative.
std::string sign_doubt(const SingleComparison& c, const ConditionWorld& world) {
  constexpr double room_deg = 0.5;
  if (c.is_magnitude || !world.lat_deg) return "";
  const bool is_lat = c.quantity == "lat_deg";
  if (!is_lat && (c.quantity != "lon_deg" || !world.lon_deg)) return "";
  const ConditionWorld::Span span = is_lat ? *world.lat_deg : *world.lon_deg;
  const double farthest_deg = std::max(std::abs(world.lat_deg->low), std::abs(world.lat_deg->high));
  // At the poles all longitudes are near.
  if (!is_lat && farthest_deg + room_deg >= 90) return "";
  const double more_deg = is_lat ? room_deg : room_deg / std::cos(radians(farthest_deg + room_deg));
  const double low = span.low - more_deg, high = span.high + more_deg;
  // About the equator, the prime meridian and the date line both signs are near.
  if (low * high <= 0 || high > 180 || low < -180) return "";
  if (-c.number < low || -c.number > high) return "";
  SingleComparison there = c;
  there.bounds = {low, high};
  return fmt::format("'{} {} {:g}' {} holds where this plan is, at {} of {}; did you mean {:g}?",
                     c.shown, c.how, c.number, never_holds(there) ? "never" : "always", c.quantity,
                     span.low == span.high ? fmt::format("{:.7g}", span.low)
                                           : fmt::format("{:.7g} to {:.7g}", span.low, span.high),
                     -c.number);
}

// Whether a number is so far out of bounds that another unit was meant, whichever way it is
// compared.
bool is_far_outside(const SingleComparison& c, double share) {
  const double span = c.bounds.high - c.bounds.low;
  return c.number > c.bounds.high + share * span || c.number < c.bounds.low - share * span;
}

std::string in_radians(const SingleComparison& c) {
  return fmt::format("{} is in radians, and is compared with {}: {} deg is math.rad({})", c.shown,
                     c.number, c.number, c.number);
}

// Fault of a number that can only be a percentage or an angle in degrees.
std::string fault_of(const SingleComparison& c) {
  if (c.bounds.high == 1 && c.number >= 2) {
    return fmt::format("{} is 1 at most, and is compared with {}: 80 % is 0.8", c.shown, c.number);
  }
  const bool is_angle = c.quantity.ends_with("_rad");
  return is_angle && std::abs(c.number) > 2 * std::numbers::pi ? in_radians(c) : "";
}

// Doubt about a comparison that is likely to be a mistake, or that never holds.
std::string doubt_of(const SingleComparison& c, const ConditionWorld& world, bool is_alone) {
  constexpr double angle_share = 0.3, longitude_share = 0.02;
  if (c.quantity.ends_with("_rad") && is_outside(c) &&
      (never_holds(c) || is_far_outside(c, angle_share))) {
    return in_radians(c);
  }
  if (c.quantity == "lon_deg" && is_outside(c) &&
      (never_holds(c) || is_far_outside(c, longitude_share))) {
    const double turned = c.number - 360 * std::round(c.number / 360);
    return fmt::format("{} is from -180 to 180, and is compared with {:g}: that is {:g}", c.shown,
                       c.number, turned);
  }
  if (never_holds(c)) return never_text(c, bounds_text(c));
  if (c.quantity == "time_s" && c.how == "==" && c.number != std::floor(c.number)) {
    return never_text(c, "conditions are asked at whole seconds");
  }
  if (std::string hours = hours_doubt(c, is_alone); !hours.empty()) return hours;
  if (std::string late = late_doubt(c, world, is_alone); !late.empty()) return late;
  if (std::string sign = sign_doubt(c, world); !sign.empty()) return sign;
  return scale_fault(c, world);
}

}  // namespace

std::string sizes_fault(const std::vector<ConditionWord>& words) {
  for (const SingleComparison& comparison : comparisons_of(words)) {
    if (std::string fault = fault_of(comparison); !fault.empty()) return fault;
  }
  return "";
}

std::string sizes_doubt(const std::vector<ConditionWord>& words, const ConditionWorld& world) {
  const bool is_alone = std::ranges::none_of(
      words, [](const ConditionWord& word) { return word.text == "and" || word.text == "or"; });
  for (const SingleComparison& comparison : comparisons_of(words)) {
    if (std::string doubt = doubt_of(comparison, world, is_alone); !doubt.empty()) return doubt;
  }
  return "";
}

}  // namespace lsos
