#include "base/units.h"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/quantity_advice.h"

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

// The short decimal number whose reciprocal the factor is (100 for cm, 3.6 for km/h); 0 when there
// is none. Dividing by it rounds once, so that 35 cm is 0.35 m exactly.
double divisor(const Unit& unit) {
  const double short_reciprocal = std::round(1e6 / unit.si_factor) / 1e6;
  return unit.si_factor < 1 && 1 / short_reciprocal == unit.si_factor ? short_reciprocal : 0;
}

double to_si(double value, const Unit& unit) {
  const double by = divisor(unit);
  return by > 0 ? value / by : value * unit.si_factor;
}

double from_si(double value_si, const Unit& unit) {
  const double by = divisor(unit);
  return by > 0 ? value_si * by : value_si / unit.si_factor;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

// "a speed is allowed, such as '2 m/s'"
std::string allowed(const Unit& unit) {
  const bool is_vowel = std::string_view("aeiou").find(unit.kind.front()) != std::string_view::npos;
  std::string example = fmt::format("'2 {}'", unit.symbol);
  if (unit.kind == "fraction") example = "'0.5' or '50 %'";
  if (unit.kind == "duration") example = "'90 s', '1.5 h' or 'PT1H30M'";
  return fmt::format("{} {} is allowed, such as {}", is_vowel ? "an" : "a", unit.kind, example);
}

std::string wrong_unit(std::string_view symbol, const Unit& wanted) {
  if (const Unit* other = find_unit(symbol)) {
    return fmt::format("'{}' is a unit of {}; {}", symbol, other->kind, allowed(wanted));
  }
  std::string list;
  for (const Unit& unit : units) {
    if (unit.kind != wanted.kind) continue;
    list += fmt::format("{}{}", list.empty() ? "" : ", ", unit.symbol);
  }
  return fmt::format("there is no unit '{}'; units of {} are {}", symbol, wanted.kind, list);
}

// Blanks that tables and web pages put between a number and its unit.
std::string with_plain_blanks(std::string_view text) {
  std::string plain(text);
  for (const std::string_view blank : {"\u00a0", "\u2009", "\u202f"}) {
    for (std::size_t at = plain.find(blank); at != std::string::npos; at = plain.find(blank, at)) {
      plain.replace(at, blank.size(), " ");
    }
  }
  return plain;
}

// "1 h 30 min", "2 d 3h": parts from the longest unit to the shortest. Absent: it is none.
std::optional<double> parse_duration_in_parts(std::string_view text) {
  double total_s = 0, last_unit_s = std::numeric_limits<double>::infinity();
  int parts = 0;
  for (; !text.empty(); ++parts) {
    if (!is_digit(text.front())) return {};
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc{}) return {};
    text = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    std::size_t letters = 0;
    while (letters < text.size() && !is_digit(text[letters]) && !is_space(text[letters])) ++letters;
    const Unit* unit = find_unit(text.substr(0, letters));
    if (unit == nullptr || unit->kind != "duration" || unit->si_factor >= last_unit_s) return {};
    last_unit_s = unit->si_factor;
    total_s += to_si(value, *unit);
    text = trimmed(text.substr(letters));
  }
  return parts > 1 ? std::optional(total_s) : std::nullopt;
}

// One part of an ISO 8601 duration: its letter, its length, and whether it stands after 'T'.
struct DurationPart {
  char letter;
  double length_s;
  bool is_time;
};
constexpr std::array duration_parts{
    DurationPart{'W', 7 * 86400.0, false},
    DurationPart{'D', 86400, false},
    DurationPart{'H', 3600, true},
    DurationPart{'M', 60, true},
    DurationPart{'S', 1, true},
};

// ISO 8601-1:2019, 5.5.2, without years and months, which have no fixed length. The last part may
// have a fraction.
Parsed<double> parse_iso_duration(std::string_view text) {
  const std::string refusal = fmt::format(
      "'{}' is no ISO 8601 duration; weeks, days, hours, minutes and seconds in this order are "
      "allowed, such as 'P2DT3H' or 'PT1H30M'",
      text);
  std::string_view rest = text.substr(1);
  double total_s = 0;
  std::size_t next_part = 0;
  bool is_time = false;
  bool has_fraction = false;
  bool has_part = false;  // since 'P', or since 'T'
  while (!rest.empty()) {
    if (rest.front() == 'T' && !is_time) {
      is_time = true;
      has_part = false;
      rest.remove_prefix(1);
      continue;
    }
    if (has_fraction || !is_digit(rest.front())) return {{}, refusal};
    std::string number;
    while (!rest.empty() &&
           (is_digit(rest.front()) || rest.front() == '.' || rest.front() == ',')) {
      number += rest.front() == ',' ? '.' : rest.front();
      rest.remove_prefix(1);
    }
    has_fraction = number.find('.') != std::string::npos;
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value,
                                              std::chars_format::fixed);
    if (error != std::errc{} || end != number.data() + number.size() || rest.empty()) {
      return {{}, refusal};
    }
    while (next_part < duration_parts.size() && (duration_parts[next_part].letter != rest.front() ||
                                                 duration_parts[next_part].is_time != is_time)) {
      ++next_part;
    }
    if (next_part == duration_parts.size()) return {{}, refusal};
    total_s += value * duration_parts[next_part].length_s;
    ++next_part;
    has_part = true;
    rest.remove_prefix(1);
  }
  if (!has_part || !std::isfinite(total_s)) return {{}, refusal};
  return {total_s, {}};
}

}  // namespace

const Unit* find_unit(std::string_view symbol) {
  for (const Unit& unit : units) {
    if (unit.symbol == symbol) return &unit;
  }
  return nullptr;
}

std::span<const Unit> all_units() { return units; }

namespace {

// Why a text is no quantity of the unit's kind.
Parsed<double> refused(std::string_view text, const Unit& unit, const std::string& why) {
  return {{}, why + quantity_advice(text, unit)};
}

Parsed<double> parse_plain_quantity(std::string_view text, const Unit& unit) {
  if (text.empty()) return {{}, fmt::format("there is no text; {}", allowed(unit))};
  if (unit.kind == "duration" && text.front() == 'P') return parse_iso_duration(text);

  std::string_view number = text;
  if (number.front() == '+' && number.size() > 1 && number[1] != '-') number.remove_prefix(1);
  double value = 0;
  const char* const text_end = number.data() + number.size();
  const auto [end, error] = std::from_chars(number.data(), text_end, value);
  if (error == std::errc::invalid_argument || (error == std::errc{} && !std::isfinite(value))) {
    return refused(text, unit, fmt::format("'{}' is no number; {}", text, allowed(unit)));
  }
  const Unit* given = &unit;
  const std::string_view symbol = trimmed({end, static_cast<std::size_t>(text_end - end)});
  if (symbol.starts_with(',')) {
    return refused(text, unit, fmt::format("'{}' has a comma; a decimal point is allowed", text));
  }
  // "1 500", "1'500", "1.5.2", "01:30:00"
  const bool goes_on = symbol.find_first_of("0123456789.:'") == 0 && symbol != "'";
  if (goes_on) {
    return refused(text, unit, fmt::format("'{}' is no number; {}", text, allowed(unit)));
  }
  if (!symbol.empty()) {
    given = find_unit(symbol);
    if (given == nullptr && unit.kind == "duration") {
      if (const auto total_s = parse_duration_in_parts(text)) return {*total_s, {}};
    }
    if (given == nullptr || given->kind != unit.kind) {
      return refused(text, unit, wrong_unit(symbol, unit));
    }
  }
  const double value_si = to_si(value, *given);
  if (error == std::errc::result_out_of_range || !std::isfinite(value_si)) {
    return {{}, fmt::format("'{}' is outside what a number can hold", text)};
  }
  return {value_si, {}};
}

}  // namespace

Parsed<double> parse_quantity(std::string_view text, const Unit& unit) {
  const std::string plain = with_plain_blanks(text);
  return parse_plain_quantity(trimmed(plain), unit);
}

namespace {

std::string lower_case(std::string_view text) {
  std::string word(text);
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

std::string boolean_advice(const std::string& word) {
  if (word == "yes" || word == "y" || word == "on") return "; did you mean 'true'?";
  if (word == "no" || word == "n" || word == "off") return "; did you mean 'false'?";
  return "";
}

// "10" of "10.0", as spreadsheets and tables of a GIS write it.
std::string_view without_zero_decimals(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == 0 || point == std::string_view::npos || point + 1 == text.size()) return text;
  return text.find_first_not_of('0', point + 1) == std::string_view::npos ? text.substr(0, point)
                                                                          : text;
}

}  // namespace

Parsed<std::int64_t> parse_integer(std::string_view text) {
  text = trimmed(text);
  std::string_view digits = without_zero_decimals(text);
  if (digits.size() > 1 && digits[0] == '+' && is_digit(digits[1])) digits.remove_prefix(1);
  std::int64_t value = 0;
  const char* const text_end = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), text_end, value);
  if (error == std::errc::result_out_of_range) {
    return {{}, fmt::format("'{}' is outside what a whole number can hold", text)};
  }
  if (error != std::errc{} || end != text_end) {
    return {{}, fmt::format("'{}' is no whole number{}", text, whole_number_advice(text))};
  }
  return {value, {}};
}

Parsed<bool> parse_boolean(std::string_view text) {
  text = trimmed(text);
  const std::string word = lower_case(text);  // spreadsheets write TRUE
  if (word == "true" || word == "1") return {true, {}};
  if (word == "false" || word == "0") return {false, {}};
  return {{},
          fmt::format("'{}' is neither true nor false; true, false, 1, 0 are allowed{}", text,
                      boolean_advice(word))};
}

std::string format_quantity(double value_si, const Unit& unit) {
  const double value = from_si(value_si, unit);
  double shortest = value;
  for (int digits = 1; digits <= 17; ++digits) {
    const std::string text = fmt::format("{:.{}e}", value, digits - 1);
    double rounded = 0;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    if (to_si(rounded, unit) == value_si) {
      shortest = rounded;
      break;
    }
  }
  const std::string symbol = unit.symbol == "1" ? "" : fmt::format(" {}", unit.symbol);
  return fmt::format("{}{}", shortest, symbol);
}

}  // namespace lsos
