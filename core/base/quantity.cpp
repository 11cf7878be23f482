#include "base/quantity.h"

#include <fmt/format.h>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/iso_duration.h"
#include "base/quantity_advice.h"
#include "base/text.h"

namespace lsos {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
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
  for (const Unit& unit : all_units()) {
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

}  // namespace

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
