#include "interchange/value_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/quantity.h"
#include "base/sim_time.h"
#include "base/text.h"
#include "interchange/cell_text.h"

namespace lsos {

namespace {

// Unit of a bare number, as the plan's reader takes it.
const Unit& declared_unit(const FieldDeclaration& field) {
  if (field.kind == FieldKind::duration) return *find_unit("s");
  return field.unit == nullptr ? *find_unit("1") : *field.unit;
}

std::optional<double> value_si(const std::string& text, const FieldDeclaration& field) {
  const Parsed<double> value = parse_quantity(text, declared_unit(field));
  if (!value) return {};
  return field.kind == FieldKind::duration ? rounded_s(*value.value) : *value.value;
}

bool is_bare(const std::string& text) {
  return text.find_first_not_of("0123456789.+-eE") == std::string::npos;
}

// The unit that a text says; nullptr for a bare number and other notations.
const Unit* unit_in(const std::string& text) {
  const std::size_t end = text.find_last_of("0123456789.");
  if (end == std::string::npos || !is_bare(text.substr(0, end + 1))) return nullptr;
  return find_unit(trimmed(std::string_view(text).substr(end + 1)));
}

std::string number_in(double value, const Unit& unit) {
  const std::string text = format_quantity(value, unit);
  return text.substr(0, text.find(' '));
}

// Units that people use beside the field's own.
std::vector<const Unit*> usual_units(const FieldDeclaration& field) {
  std::vector<const Unit*> units{&declared_unit(field)};
  if (field.kind == FieldKind::duration && field.unit != nullptr) units = {field.unit};
  const auto add = [&](const char* symbol) {
    const Unit* unit = find_unit(symbol);
    if (std::ranges::find(units, unit) == units.end()) units.push_back(unit);
  };
  const std::string_view kind = units.front()->kind;
  if (kind == "duration") {
    for (const char* symbol : {"min", "h", "s"}) add(symbol);
  }
  if (kind == "speed") add("km/h");
  if (kind == "fraction") add("%");
  return units;
}

// Units that the texts say, the most frequent first.
std::vector<const Unit*> written_units(const std::vector<DeclaredText>& texts) {
  std::vector<const Unit*> units;
  std::map<const Unit*, int> counts;
  for (const auto& [field, text] : texts) {
    const Unit* unit = unit_in(text);
    if (unit == nullptr || unit->kind != declared_unit(*field).kind) continue;
    if (++counts[unit] == 1) units.push_back(unit);
  }
  std::ranges::stable_sort(units, std::greater<>(), [&](const Unit* unit) { return counts[unit]; });
  return units;
}

}  // namespace

bool has_unit(const FieldDeclaration& field) {
  if (field.kind == FieldKind::duration) return true;
  return field.kind == FieldKind::number && field.amount_of.empty();
}

std::string text_in_unit(const std::string& text, const FieldDeclaration& field, const Unit& unit) {
  const std::optional<double> value = value_si(text, field);
  const auto reads_equal = [&](const std::string& cell) {
    const std::string header = unit.symbol == "1" ? "" : std::string(unit.symbol);
    const std::string read = field_text(cell, field, header, false);
    return value ? value_si(read, field) == value : read == text;
  };
  if (!value) return reads_equal(text) ? text : "";
  if (const std::string number = number_in(*value, unit); reads_equal(number)) return number;
  if (reads_equal(text)) return text;
  const std::string with_own = fmt::format("{} {}", text, declared_unit(field).symbol);
  return is_bare(text) && reads_equal(with_own) ? with_own : "";
}

const Unit* shortest_unit(const std::vector<DeclaredText>& texts) {
  if (texts.empty()) return nullptr;
  for (const auto& [field, text] : texts) {
    const bool is_alike =
        has_unit(*field) && declared_unit(*field).kind == declared_unit(*texts.front().first).kind;
    if (!is_alike) return nullptr;
  }
  std::vector<const Unit*> units = written_units(texts);
  // Many seconds are what a reader of sheets has made of "2:00".
  const bool is_seconds = units.size() == 1 && units.front()->symbol == "s";
  if (units.empty() || is_seconds) units = usual_units(*texts.front().first);
  const Unit* shortest = nullptr;
  std::size_t least = 0;
  for (const Unit* unit : units) {
    std::size_t total = 0;
    const bool can_say = std::ranges::all_of(texts, [&](const DeclaredText& each) {
      const std::string cell = text_in_unit(each.second, *each.first, *unit);
      total += cell.size();
      return !cell.empty();
    });
    if (!can_say || (shortest != nullptr && total >= least)) continue;
    shortest = unit;
    least = total;
  }
  return shortest;
}

std::string text_with_unit(const std::string& text, const FieldDeclaration& field) {
  const Unit* written = unit_in(text);
  if (!has_unit(field) || (written != nullptr && written->symbol != "s")) return text;
  const std::optional<double> value = value_si(text, field);
  const Unit* unit = value ? shortest_unit({{&field, text}}) : nullptr;
  if (unit == nullptr) return text;
  const std::string in_unit = format_quantity(*value, *unit);
  return value_si(in_unit, field) == value ? in_unit : text;
}

}  // namespace lsos
