#include "interchange/cell_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "base/text.h"
#include "base/unit_spellings.h"
#include "interchange/clock_text.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

bool is_number(FieldKind kind) {
  return kind == FieldKind::number || kind == FieldKind::integer || kind == FieldKind::duration ||
         kind == FieldKind::moment;
}

// "5,5" is 5.5: one comma between digits, and no point.
std::string with_point(const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto is_digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  if (comma == std::string::npos || comma == 0 || !is_digit(comma - 1) || !is_digit(comma + 1)) {
    return text;
  }
  if (text.find(',', comma + 1) != std::string::npos || text.find('.') != std::string::npos) {
    return text;
  }
  std::string pointed = text;
  pointed[comma] = '.';
  return pointed;
}

bool is_bare_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

std::string kind_of(const FieldDeclaration& field) {
  const bool is_time = field.kind == FieldKind::duration || field.kind == FieldKind::moment;
  if (is_time) return "duration";
  return std::string(field.unit == nullptr ? "fraction" : field.unit->kind);
}

// The number with its unit, as a plan reads them: "mph" becomes km/h.
std::string with_unit(const std::string& number, const std::string& unit, std::string_view kind) {
  if (find_unit(unit) != nullptr) return fmt::format("{} {}", number, unit);
  const auto meant = spelled_unit(unit, kind);
  if (!meant) return number;
  if (meant->factor == 1) return fmt::format("{} {}", number, meant->symbol);
  double value = 0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  return fmt::format("{} {}", value * meant->factor, meant->symbol);
}

std::string boolean_text(const std::string& text) {
  // TRUE and FALSE of a spreadsheet come as 1 and 0.
  constexpr std::array<std::string_view, 5> yes{"yes", "y", "x", "true", "1"};
  constexpr std::array<std::string_view, 5> no{"no", "n", "-", "false", "0"};
  const std::string word = lower_case(text);
  if (std::ranges::find(yes, word) != yes.end()) return "true";
  if (std::ranges::find(no, word) != no.end()) return "false";
  return text;
}

}  // namespace

std::string field_text(const std::string& text, const FieldDeclaration& field,
                       const std::string& unit, bool has_commas) {
  if (field.kind == FieldKind::boolean) return boolean_text(text);
  if (!is_number(field.kind)) return text;
  std::string number = has_commas ? with_point(text) : text;
  if (field.kind == FieldKind::duration) {
    if (const auto span_s = clock_s(number)) return fmt::format("{} s", *span_s);
  }
  if (!is_bare_number(number)) {
    return field.amount_of.empty() ? with_known_unit(number, kind_of(field)) : number;
  }
  return unit.empty() ? number : with_unit(number, unit, kind_of(field));
}

std::string with_known_unit(const std::string& text, std::string_view kind) {
  const std::size_t end = text.find_last_of("0123456789.");
  if (end == std::string::npos || !is_bare_number(text.substr(0, end + 1))) return text;
  const std::string unit(trimmed(std::string_view(text).substr(end + 1)));
  // One letter may be a unit of another kind.
  if (unit.size() < 2 || find_unit(unit) != nullptr) return text;
  return spelled_unit(unit, kind) ? with_unit(text.substr(0, end + 1), unit, kind) : text;
}

std::string unit_fault(const std::string& unit, const FieldDeclaration& field) {
  if (unit.empty() || !is_number(field.kind)) return "";
  const std::string kind = kind_of(field);
  const Unit* known = find_unit(unit);
  if (known != nullptr ? known->kind == kind : spelled_unit(unit, kind).has_value()) return "";
  std::string allowed;
  for (const Unit& each : all_units()) {
    if (each.kind == kind) allowed += fmt::format("{}{}", allowed.empty() ? "" : ", ", each.symbol);
  }
  return fmt::format("({}) is no unit of {}; there are {}", unit, field.name, allowed);
}

namespace {

// Whether it is one, behind any number of apostrophes.
bool is_ods_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  return text.starts_with("of:=");
}

}  // namespace

std::string guarded_in_ods(const std::string& text) {
  return is_ods_formula(text) ? "'" + text : text;
}

std::string unguarded_in_ods(const std::string& text) {
  return text.starts_with('\'') && is_ods_formula(text) ? text.substr(1) : text;
}

}  // namespace lsos
