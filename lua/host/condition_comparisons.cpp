#include "lua/host/condition_comparisons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "base/rounding.h"
#include "lua/host/condition.h"
#include "record/quantities.h"

namespace lsos {

namespace {

// Possible values of a quantity.
Bounds bounds_of(std::string_view quantity) {
  struct Known {
    std::string_view quantity;
    Bounds bounds;
  };
  if (quantity.starts_with("distance_to(") || quantity.starts_with("resource(")) {
    return {0, infinite};
  }
  static constexpr std::array known{
      Known{"lon_deg", {-180, 180}},
      Known{"lat_deg", {-90, 90}},
      Known{"time_s", {0, infinite}},
  };
  if (const Quantity* logged = find_quantity(quantity)) return {logged->least, logged->greatest};
  const auto found = std::ranges::find(known, quantity, &Known::quantity);
  return found == known.end() ? Bounds{-infinite, infinite} : found->bounds;
}

bool is_symbol(const std::vector<ConditionWord>& words, std::size_t at, std::string_view text) {
  return at < words.size() && words[at].kind == ConditionWord::Kind::symbol &&
         words[at].text == text;
}

// One side of a comparison: a quantity or a number.
struct Side {
  std::string quantity;       // "" for a number
  bool is_magnitude = false;  // math.abs of it
  double sign = 1;
  double number = 0;
  std::size_t end = 0;  // index of the word behind it
};

bool is_math(const std::vector<ConditionWord>& words, std::size_t at, std::string_view function) {
  return at + 5 < words.size() && words[at].text == "math" && words[at + 2].text == function &&
         is_symbol(words, at + 3, "(") && is_symbol(words, at + 5, ")");
}

double number_of_word(const ConditionWord& number) {
  return std::strtod(number.text.c_str(), nullptr);
}

bool is_number(const std::vector<ConditionWord>& words, std::size_t at) {
  return at < words.size() && words[at].kind == ConditionWord::Kind::number;
}

// A number or a product of numbers: 20, math.rad(20), 20 / 3.6, 30 * 3.6e6.
std::optional<Side> compared_number_at(const std::vector<ConditionWord>& words, std::size_t at) {
  Side side;
  if (is_math(words, at, "rad") && is_number(words, at + 4)) {
    side.number = number_of_word(words[at + 4]) * std::numbers::pi / 180;
    side.end = at + 6;
  } else if (is_number(words, at)) {
    side.number = number_of_word(words[at]);
    side.end = at + 1;
  } else {
    return {};
  }
  while (is_number(words, side.end + 1)) {
    const double by = number_of_word(words[side.end + 1]);
    if (is_symbol(words, side.end, "*")) {
      side.number *= by;
    } else if (is_symbol(words, side.end, "/")) {
      side.number /= by;
    } else {
      break;
    }
    side.end += 2;
  }
  return side;
}

// A quantity: charge, math.abs(roll_rad), distance_to('Base').
std::optional<Side> quantity_at(const std::vector<ConditionWord>& words, std::size_t at) {
  Side side;
  side.is_magnitude = is_math(words, at, "abs") && words[at + 4].kind == ConditionWord::Kind::name;
  const std::size_t name = side.is_magnitude ? at + 4 : at;
  if (name >= words.size() || words[name].kind != ConditionWord::Kind::name) return {};
  side.quantity = words[name].text;
  side.end = at + (side.is_magnitude ? 6 : 1);
  if (side.is_magnitude || !is_question(side.quantity)) return side;
  const std::string* argument = question_argument(words, at);
  if (argument == nullptr) return {};
  side.quantity += fmt::format("('{}')", *argument);
  side.end = at + (is_symbol(words, at + 1, "(") ? 4 : 2);
  return side;
}

std::optional<Side> side_at(const std::vector<ConditionWord>& words, std::size_t at) {
  const bool is_negative = is_symbol(words, at, "-");
  if (is_negative) ++at;
  std::optional<Side> side = compared_number_at(words, at);
  if (!side) side = quantity_at(words, at);
  if (side && is_negative) {
    side->sign = -1;
    side->number = -side->number;
  }
  return side;
}

// The operator at `at`: "<", "<=", ">", ">=", "==" or "~="; "" for none. It may be two words.
std::string sign_at(const std::vector<ConditionWord>& words, std::size_t at, std::size_t& end) {
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

}  // namespace

bool begins_operand(const ConditionWord& before) {
  return before.text == "(" || before.text == "and" || before.text == "or";
}
bool ends_operand(const ConditionWord& after) {
  return after.text == ")" || after.text == "and" || after.text == "or";
}

std::optional<SingleComparison> comparison_at(const std::vector<ConditionWord>& words,
                                              std::size_t at) {
  // An operand of a sum or a product is not compared by itself.
  if (at > 0 && !begins_operand(words[at - 1])) return {};
  std::optional<Side> left = side_at(words, at);
  if (!left) return {};
  std::size_t middle_end = 0;
  std::string how = sign_at(words, left->end, middle_end);
  std::optional<Side> right = how.empty() ? std::nullopt : side_at(words, middle_end);
  if (!right || left->quantity.empty() == right->quantity.empty()) return {};
  const std::size_t end = right->end;
  if (end < words.size() && !ends_operand(words[end])) return {};
  if (left->quantity.empty()) {
    std::swap(left, right);
    how = turned_round(how);
  }
  SingleComparison c{.quantity = left->quantity,
                     .shown = left->quantity,
                     .how = how,
                     .number = right->number,
                     .bounds = bounds_of(left->quantity),
                     .is_magnitude = left->is_magnitude,
                     .end = end};
  if (c.is_magnitude) {
    c.shown = fmt::format("math.abs({})", c.quantity);
    c.bounds = {0, std::max(std::abs(c.bounds.low), std::abs(c.bounds.high))};
  }
  if (left->sign < 0) {
    c.number = -c.number;
    c.how = turned_round(c.how);
  }
  return c;
}

std::vector<SingleComparison> comparisons_of(const std::vector<ConditionWord>& words) {
  std::vector<SingleComparison> all;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (auto comparison = comparison_at(words, i)) all.push_back(std::move(*comparison));
  }
  return all;
}

}  // namespace lsos
