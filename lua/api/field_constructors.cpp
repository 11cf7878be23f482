// lsos.number, integer, boolean, text, choice, duration, utc, moment: the fields that a plan may
// give to an event.
#include <fmt/format.h>

#include <algorithm>

#include "base/quantity_advice.h"
#include "base/units.h"
#include "lua/api/constructors.h"
#include "plan/declaration.h"

namespace lsos {

namespace {

void read_common(TableReader& t, FieldDeclaration& field) {
  t.text(required, "kml", field.name, "Name of the SimpleData in plans.");
  t.text(optional, "doc", field.doc, "One sentence for the mission planner.");
  t.text(optional, "example", field.example, "What `lsos-host schema` writes into its form.");
}

void read_required(TableReader& t, FieldDeclaration& field) {
  t.boolean(optional, "required", field.is_required, "The plan must give it (default false).");
  if (field.is_required && field.default_value) {
    t.fault(fmt::format("'{}' is required and has a default: one of the two", field.name));
  }
}

void check_limits(TableReader& t, const FieldDeclaration& field) {
  if (field.min_si && field.max_si && *field.min_si > *field.max_si) {
    t.fault(fmt::format("'{}': min is above max", field.name));
  }
}

void check_default(TableReader& t, const FieldDeclaration& field, double value_si) {
  if ((field.min_si && value_si < *field.min_si) || (field.max_si && value_si > *field.max_si)) {
    t.fault(fmt::format("'{}': the default is outside min..max", field.name));
  }
}

void read_quantity(TableReader& t, FieldDeclaration& field, const char* unit_symbol,
                   const char* unit_doc) {
  std::string symbol = unit_symbol;
  t.text(optional, "unit", symbol, unit_doc);
  field.unit = find_unit(symbol);
  if (field.unit == nullptr) {
    std::vector<std::string> symbols;
    for (const Unit& unit : all_units()) symbols.emplace_back(unit.symbol);
    t.fault(fmt::format("unknown unit '{}'{}; known are {}", symbol, unit_advice(symbol),
                        fmt::join(symbols, ", ")));
    field.unit = find_unit(unit_symbol);
  }
  const auto read = [&](const char* key, std::optional<double>& value_si, const char* doc) {
    std::optional<double> value;
    t.number(optional, key, value, any_number, doc);
    if (value) value_si = to_si(*value, *field.unit);
  };
  std::optional<double> default_si;
  read("min", field.min_si, "Smallest allowed value.");
  read("max", field.max_si, "Largest allowed value.");
  read("default", default_si, "Value when the plan gives none; without one the script sees nil.");
  check_limits(t, field);
  if (default_si) {
    check_default(t, field, *default_si);
    field.default_value = *default_si;
  }
}

void read_role(TableReader& t, FieldDeclaration& field) {
  constexpr std::pair<const char*, NumberRole> roles[] = {
      {"drive_speed", NumberRole::drive_speed},
      {"arrival_radius", NumberRole::arrival_radius},
      {"outside_power", NumberRole::outside_power},
      {"following_distance", NumberRole::following_distance}};
  t.word(optional, "role", roles, field.role,
         "What checks and estimates before the run read it for: 'drive_speed', the speed that a "
         "drive requests; 'arrival_radius', the distance from its target within which a drive has "
         "arrived; 'outside_power', what it requests from outside or from a power source; "
         "'following_distance', what it keeps to a rover that it follows. At most one number of an "
         "event has each.");
  constexpr std::pair<NumberRole, const char*> kinds[] = {
      {NumberRole::drive_speed, "speed"},
      {NumberRole::arrival_radius, "length"},
      {NumberRole::outside_power, "power"},
      {NumberRole::following_distance, "length"}};
  for (const auto& [role, kind] : kinds) {
    if (field.role != role || field.unit->kind == kind) continue;
    t.fault(fmt::format("'{}': its role needs a unit of {}, not '{}'", field.name, kind,
                        field.unit->symbol));
  }
}

void read_number(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::number;
  read_common(t, field);
  read_quantity(t, field, "1", "Unit of a bare number in plans, and of min, max, default here.");
  read_role(t, field);
  t.text(optional, "amount_of", field.amount_of,
         "Key of the text that names a resource of the rover: so much of that is used up; checked "
         "before the run against what is aboard.");
  read_required(t, field);
}

void read_duration(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::duration;
  read_common(t, field);
  read_quantity(t, field, "s",
                "Unit of min, max, default here; a bare number in plans is seconds.");
  if (field.unit->kind != "duration") {
    t.fault(fmt::format("'{}': the unit of a duration is s, min, h or d, not '{}'", field.name,
                        field.unit->symbol));
  }
  if (!field.min_si) field.min_si = 0;
  if (!field.max_si) field.max_si = longest_duration_s;
  read_required(t, field);
}

void read_integer(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::integer;
  read_common(t, field);
  const auto read = [&](const char* key, std::optional<double>& value, const char* doc) {
    std::optional<std::int64_t> whole;
    t.integer(optional, key, whole, any_number, doc);
    if (whole) value = static_cast<double>(*whole);
  };
  std::optional<std::int64_t> default_value;
  read("min", field.min_si, "Smallest allowed value.");
  read("max", field.max_si, "Largest allowed value.");
  t.integer(optional, "default", default_value, any_number,
            "Value when the plan gives none; without one the script sees nil.");
  check_limits(t, field);
  if (default_value) {
    check_default(t, field, static_cast<double>(*default_value));
    field.default_value = *default_value;
  }
  read_required(t, field);
}

void read_boolean(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::boolean;
  read_common(t, field);
  std::optional<bool> flag;
  t.boolean(optional, "default", flag, "Value when the plan gives none.");
  if (flag) field.default_value = *flag;
  read_required(t, field);
}

void read_text_default(TableReader& t, FieldDeclaration& field) {
  std::optional<std::string> text;
  t.text(optional, "default", text, "Value when the plan gives none.");
  if (text) field.default_value = *text;
}

void read_text(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::text;
  read_common(t, field);
  constexpr std::pair<const char*, NameOf> things[] = {{"panel", NameOf::panel},
                                                       {"stowable_panel", NameOf::stowable_panel},
                                                       {"turning_panel", NameOf::turning_panel},
                                                       {"resource", NameOf::resource},
                                                       {"antenna", NameOf::antenna},
                                                       {"stance", NameOf::stance},
                                                       {"power_source", NameOf::power_source},
                                                       {"other", NameOf::other},
                                                       {"leader", NameOf::leader}};
  t.word(
      optional, "names", things, field.names,
      "What it must name, checked before the run: a 'panel', 'resource', 'antenna' or 'stance' of "
      "the rover, a 'stowable_panel' or 'turning_panel' (without these two and 'antenna' all that "
      "the rover has are meant, and there must be one), a 'power_source', an asset that has power "
      "to give and is within reach, any 'other' rover or asset, or a 'leader', another rover that "
      "the rover follows.");
  read_text_default(t, field);
  read_required(t, field);
}

void read_choice(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::choice;
  read_common(t, field);
  t.texts(required, "choices", field.choices, "The words that the plan may give.");
  read_text_default(t, field);
  if (field.default_value && !field.choices.empty()) {
    const std::string& text = std::get<std::string>(*field.default_value);
    if (std::ranges::find(field.choices, text) == field.choices.end()) {
      t.fault(fmt::format("'{}': the default '{}' is not among the choices {}", field.name, text,
                          fmt::join(field.choices, ", ")));
    }
  }
  read_required(t, field);
}

void read_utc(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::utc;
  read_common(t, field);
  read_required(t, field);
}

void read_moment(TableReader& t, FieldDeclaration& field) {
  field.kind = FieldKind::moment;
  read_common(t, field);
  read_required(t, field);
}

}  // namespace

std::vector<Constructor> field_constructors() {
  return {
      constructor<FieldDeclaration, read_number>(
          "number", "A quantity. The script key ends in the SI suffix of its unit."),
      constructor<FieldDeclaration, read_integer>("integer", "A whole number."),
      constructor<FieldDeclaration, read_boolean>("boolean", "true or false."),
      constructor<FieldDeclaration, read_text>("text", "Any text."),
      constructor<FieldDeclaration, read_choice>("choice", "One of some words."),
      constructor<FieldDeclaration, read_duration>(
          "duration", "A length of time, seconds in the script; the key ends in _s."),
      constructor<FieldDeclaration, read_utc>(
          "utc", "A moment; in the script seconds since the mission's start; the key ends in _s."),
      constructor<FieldDeclaration, read_moment>(
          "moment",
          "The same, and a plan may also give it as a duration from the mission's start."),
  };
}

}  // namespace lsos
