#include "lua/condition_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

namespace lsos {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Bounds {
  double low = -infinite, high = infinite;
};

// What a quantity can be.
Bounds bounds_of(std::string_view quantity) {
  constexpr double half_turn_rad = std::numbers::pi, quarter_rad = half_turn_rad / 2;
  struct Known {
    std::string_view quantity;
    Bounds bounds;
  };
  static constexpr std::array known{
      Known{"charge", {0, 1}},
      Known{"sun_fraction", {0, 1}},
      Known{"incidence", {0, 1}},
      Known{"slip", {-infinite, 1}},
      Known{"slip_max", {-infinite, 1}},
      Known{"slope_rad", {0, quarter_rad}},
      Known{"pitch_rad", {-quarter_rad, quarter_rad}},
      // A rover that has rolled farther lies on its roof.
      Known{"roll_rad", {-quarter_rad, quarter_rad}},
      Known{"heading_rad", {0, 2 * half_turn_rad}},
      Known{"lon_deg", {-180, 180}},
      Known{"lat_deg", {-90, 90}},
      Known{"time_s", {0, infinite}},
      Known{"speed_mps", {0, infinite}},
      Known{"distance_m", {0, infinite}},
      Known{"energy_j", {0, infinite}},
  };
  const auto found = std::ranges::find(known, quantity, &Known::quantity);
  return found == known.end() ? Bounds{} : found->bounds;
}

bool is_symbol(const std::vector<ConditionWord>& words, std::size_t at, std::string_view text) {
  return at < words.size() && words[at].kind == ConditionWord::Kind::symbol &&
         words[at].text == text;
}

// One side of a comparison: a quantity or a number.
struct Side {
  std::string quantity;  // "" for a number
  bool is_size = false;  // math.abs of it
  double sign = 1;
  double number = 0;
  std::size_t end = 0;  // behind it
};

std::optional<Side> side_at(const std::vector<ConditionWord>& words, std::size_t at) {
  Side side;
  if (is_symbol(words, at, "-")) {
    side.sign = -1;
    ++at;
  }
  if (at >= words.size()) return {};
  if (words[at].kind == ConditionWord::Kind::number) {
    side.number = side.sign * std::strtod(words[at].text.c_str(), nullptr);
    side.end = at + 1;
    return side;
  }
  if (words[at].kind != ConditionWord::Kind::name) return {};
  const bool is_abs = words[at].text == "math" && at + 5 < words.size() &&
                      words[at + 2].text == "abs" && is_symbol(words, at + 3, "(") &&
                      words[at + 4].kind == ConditionWord::Kind::name &&
                      is_symbol(words, at + 5, ")");
  side.is_size = is_abs;
  side.quantity = words[is_abs ? at + 4 : at].text;
  side.end = at + (is_abs ? 6 : 1);
  return side;
}

// "<", "<=", ">", ">=", "==" or "~="; "" for none. It may be two words.
std::string comparison_at(const std::vector<ConditionWord>& words, std::size_t at,
                          std::size_t& end) {
  std::string text;
  for (end = at; end < words.size() && text.size() < 2; ++end) {
    const bool is_part =
        words[end].kind == ConditionWord::Kind::symbol &&
        std::string_view("<>=~").find(words[end].text[0]) != std::string_view::npos;
    if (!is_part) break;
    text += words[end].text;
  }
  return text;
}

std::string turned_round(const std::string& comparison) {
  if (comparison.starts_with('<')) return ">" + comparison.substr(1);
  if (comparison.starts_with('>')) return "<" + comparison.substr(1);
  return comparison;
}

// A quantity on the left of a number.
struct Comparison {
  std::string quantity, shown, how;
  double number = 0;
  Bounds bounds;
};

bool is_outside(const Comparison& c) { return c.number < c.bounds.low || c.number > c.bounds.high; }

bool never_holds(const Comparison& c) {
  if (c.how == "<") return c.number <= c.bounds.low;
  if (c.how == ">") return c.number >= c.bounds.high;
  if (c.how == "<=") return c.number < c.bounds.low;
  if (c.how == ">=") return c.number > c.bounds.high;
  return c.how == "==" && is_outside(c);
}

std::string never_text(const Comparison& c, const std::string& why) {
  return fmt::format("'{} {} {:g}' never holds: {}", c.shown, c.how, c.number, why);
}

std::string bounds_text(const Comparison& c) {
  if (std::isinf(c.bounds.high)) return fmt::format("{} is {:g} at least", c.shown, c.bounds.low);
  if (std::isinf(c.bounds.low)) return fmt::format("{} is {:g} at most", c.shown, c.bounds.high);
  return fmt::format("{} is from {:.4g} to {:.4g}", c.shown, c.bounds.low, c.bounds.high);
}

// An energy in kWh or a speed in km/h, which only the rover's own tell from one in SI.
std::string scale_fault(const Comparison& c, const ConditionWorld& world) {
  constexpr double overspeed = 1.5, j_per_kwh = 3.6e6, kmh_per_mps = 3.6;
  // An empty battery is asked for by 0 or by 1 J.
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

// A number so far outside that another unit was meant, whichever way it is compared.
bool is_far_outside(const Comparison& c, double share) {
  const double span = c.bounds.high - c.bounds.low;
  return c.number > c.bounds.high + share * span || c.number < c.bounds.low - share * span;
}

std::string in_radians(const Comparison& c) {
  return fmt::format("{} is in radians, and is compared with {}: {} deg is math.rad({})", c.shown,
                     c.number, c.number, c.number);
}

// A percentage or an angle in degrees, which can be nothing else.
std::string fault_of(const Comparison& c) {
  if (c.bounds.high == 1 && c.number >= 2) {
    return fmt::format("{} is 1 at most, and is compared with {}: 80 % is 0.8", c.shown, c.number);
  }
  const bool is_angle = c.quantity.ends_with("_rad");
  return is_angle && std::abs(c.number) > 2 * std::numbers::pi ? in_radians(c) : "";
}

// What is likely to be a slip, or never holds.
std::string doubt_of(const Comparison& c, const ConditionWorld& world) {
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
  return scale_fault(c, world);
}

// Comparisons of a quantity alone with a number alone.
std::vector<Comparison> comparisons_of(const std::vector<ConditionWord>& words) {
  std::vector<Comparison> all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    // What is part of a sum or a product has another size.
    if (i > 0 && !begins_operand(words[i - 1])) continue;
    std::optional<Side> left = side_at(words, i);
    if (!left) continue;
    std::size_t middle_end = 0;
    std::string how = comparison_at(words, left->end, middle_end);
    std::optional<Side> right = how.empty() ? std::nullopt : side_at(words, middle_end);
    if (!right || left->quantity.empty() == right->quantity.empty()) continue;
    if (right->end < words.size() && !ends_operand(words[right->end])) continue;
    if (left->quantity.empty()) {
      std::swap(left, right);
      how = turned_round(how);
    }
    Comparison c{left->quantity, left->quantity, how, right->number, bounds_of(left->quantity)};
    if (left->is_size) {
      c.shown = fmt::format("math.abs({})", c.quantity);
      c.bounds = {0, std::max(std::abs(c.bounds.low), std::abs(c.bounds.high))};
    }
    if (left->sign < 0) {
      c.number = -c.number;
      c.how = turned_round(c.how);
    }
    all.push_back(std::move(c));
  }
  return all;
}

}  // namespace

bool begins_operand(const ConditionWord& before) {
  return before.text == "(" || before.text == "and" || before.text == "or";
}
bool ends_operand(const ConditionWord& after) {
  return after.text == ")" || after.text == "and" || after.text == "or";
}

std::string sizes_fault(const std::vector<ConditionWord>& words) {
  for (const Comparison& comparison : comparisons_of(words)) {
    if (std::string fault = fault_of(comparison); !fault.empty()) return fault;
  }
  return "";
}

std::string sizes_doubt(const std::vector<ConditionWord>& words, const ConditionWorld& world) {
  for (const Comparison& comparison : comparisons_of(words)) {
    if (std::string doubt = doubt_of(comparison, world); !doubt.empty()) return doubt;
  }
  return "";
}

}  // namespace lsos
