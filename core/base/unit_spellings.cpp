#include "base/unit_spellings.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "base/error.h"
#include "base/replaced.h"
#include "base/units.h"

namespace lsos {

namespace {

struct Spelling {
  std::string_view word, symbol;
  double factor = 1;
};

// Spellings that depend on case, since case distinguishes milli from mega.
constexpr std::array exact{
    Spelling{"MW", "kW", 1000},     Spelling{"MWh", "kWh", 1000}, Spelling{"mJ", "J", 0.001},
    Spelling{"mWh", "Wh", 0.001},   Spelling{"mPa", "Pa", 0.001}, Spelling{"GPa", "MPa", 1000},
    Spelling{"GJ", "MJ", 1000},     Spelling{"Mg", "t"},          Spelling{"mg", "g", 0.001},
    Spelling{"mrad", "rad", 0.001}, Spelling{"NM", "km", 1.852},  Spelling{"Nm", "N m"},
    Spelling{"kNm", "kN m"},
};

constexpr double knot_kmph = 1.852, mile_km = 1.609344;  // both by definition
constexpr double sol_d = 88775.244 / 86400;              // mean solar day of Mars

// Spellings in lower case, without blanks, full stops and '^'; "per" is '/'.
constexpr std::array words{
    Spelling{"sec", "s"},
    Spelling{"secs", "s"},
    Spelling{"second", "s"},
    Spelling{"seconds", "s"},
    Spelling{"msec", "ms"},
    Spelling{"millisecond", "ms"},
    Spelling{"milliseconds", "ms"},
    Spelling{"m", "min"},
    Spelling{"mins", "min"},
    Spelling{"minute", "min"},
    Spelling{"minutes", "min"},
    Spelling{"mn", "min"},
    Spelling{"hr", "h"},
    Spelling{"hrs", "h"},
    Spelling{"hour", "h"},
    Spelling{"hours", "h"},
    Spelling{"std", "h"},
    Spelling{"day", "d"},
    Spelling{"days", "d"},
    Spelling{"week", "d", 7},
    Spelling{"weeks", "d", 7},
    Spelling{"wk", "d", 7},
    Spelling{"sol", "d", sol_d},
    Spelling{"sols", "d", sol_d},

    Spelling{"kmh", "km/h"},
    Spelling{"kph", "km/h"},
    Spelling{"kmph", "km/h"},
    Spelling{"km/hr", "km/h"},
    Spelling{"km/hrs", "km/h"},
    Spelling{"km/hour", "km/h"},
    Spelling{"kmh-1", "km/h"},
    Spelling{"kilometers/hour", "km/h"},
    Spelling{"kilometres/hour", "km/h"},
    Spelling{"mps", "m/s"},
    Spelling{"ms-1", "m/s"},
    Spelling{"m/sec", "m/s"},
    Spelling{"m/second", "m/s"},
    Spelling{"meters/second", "m/s"},
    Spelling{"metres/second", "m/s"},
    Spelling{"cmps", "cm/s"},
    Spelling{"cm/sec", "cm/s"},
    Spelling{"mm/sec", "mm/s"},
    Spelling{"km/s", "m/s", 1000},
    Spelling{"m/h", "m/s", 1 / 3600.0},
    Spelling{"m/hr", "m/s", 1 / 3600.0},
    Spelling{"m/min", "m/s", 1 / 60.0},
    Spelling{"mph", "km/h", mile_km},
    Spelling{"mi/h", "km/h", mile_km},
    Spelling{"miles/hour", "km/h", mile_km},
    Spelling{"knot", "km/h", knot_kmph},
    Spelling{"knots", "km/h", knot_kmph},
    Spelling{"kn", "km/h", knot_kmph},
    Spelling{"kt", "km/h", knot_kmph},
    Spelling{"kts", "km/h", knot_kmph},
    Spelling{"ft/s", "m/s", 0.3048},
    Spelling{"fps", "m/s", 0.3048},

    Spelling{"meter", "m"},
    Spelling{"meters", "m"},
    Spelling{"metre", "m"},
    Spelling{"metres", "m"},
    Spelling{"mtr", "m"},
    Spelling{"kilometer", "km"},
    Spelling{"kilometers", "km"},
    Spelling{"kilometre", "km"},
    Spelling{"kilometres", "km"},
    Spelling{"kms", "km"},
    Spelling{"centimeter", "cm"},
    Spelling{"centimeters", "cm"},
    Spelling{"centimetre", "cm"},
    Spelling{"centimetres", "cm"},
    Spelling{"cms", "cm"},
    Spelling{"millimeter", "mm"},
    Spelling{"millimeters", "mm"},
    Spelling{"millimetre", "mm"},
    Spelling{"millimetres", "mm"},
    Spelling{"foot", "ft"},
    Spelling{"feet", "ft"},
    Spelling{"'", "ft"},
    Spelling{"dm", "cm", 10},
    Spelling{"inch", "cm", 2.54},
    Spelling{"inches", "cm", 2.54},
    Spelling{"in", "cm", 2.54},
    Spelling{"\"", "cm", 2.54},
    Spelling{"yard", "m", 0.9144},
    Spelling{"yards", "m", 0.9144},
    Spelling{"yd", "m", 0.9144},
    Spelling{"mile", "km", mile_km},
    Spelling{"miles", "km", mile_km},
    Spelling{"mi", "km", mile_km},
    Spelling{"nmi", "km", 1.852},

    Spelling{"sqm", "m2"},
    Spelling{"qm", "m2"},
    Spelling{"ha", "m2", 1e4},
    Spelling{"km2", "m2", 1e6},
    Spelling{"mm2", "cm2", 0.01},
    Spelling{"liter", "l"},
    Spelling{"liters", "l"},
    Spelling{"litre", "l"},
    Spelling{"litres", "l"},
    Spelling{"ml", "l", 0.001},
    Spelling{"cm3", "l", 0.001},
    Spelling{"m/s/s", "m/s2"},
    Spelling{"ms-2", "m/s2"},
    Spelling{"g", "m/s2", 9.80665},

    Spelling{"\u00b0", "deg"},
    Spelling{"\u00ba", "deg"},
    Spelling{"degree", "deg"},
    Spelling{"degrees", "deg"},
    Spelling{"degs", "deg"},
    Spelling{"gon", "deg", 0.9},
    Spelling{"radian", "rad"},
    Spelling{"rads", "rad"},
    Spelling{"radians", "rad"},
    Spelling{"\u00b0/s", "deg/s"},
    Spelling{"deg/sec", "deg/s"},
    Spelling{"degrees/second", "deg/s"},
    Spelling{"rpm", "deg/s", 6},
    Spelling{"rad/sec", "rad/s"},

    Spelling{"kilogram", "kg"},
    Spelling{"kilograms", "kg"},
    Spelling{"kilo", "kg"},
    Spelling{"kilos", "kg"},
    Spelling{"kgs", "kg"},
    Spelling{"gram", "g"},
    Spelling{"grams", "g"},
    Spelling{"gr", "g"},
    Spelling{"ton", "t"},
    Spelling{"tons", "t"},
    Spelling{"tonne", "t"},
    Spelling{"tonnes", "t"},
    Spelling{"lb", "kg", 0.45359237},
    Spelling{"lbs", "kg", 0.45359237},
    Spelling{"pounds", "kg", 0.45359237},
    Spelling{"g/cc", "g/cm3"},
    Spelling{"t/m3", "kg/m3", 1000},
    Spelling{"newton", "N"},
    Spelling{"newtons", "N"},
    Spelling{"lbf", "N", 4.4482216152605},
    Spelling{"kgf", "N", 9.80665},

    Spelling{"pascal", "Pa"},
    Spelling{"bar", "kPa", 100},
    Spelling{"mbar", "Pa", 100},
    Spelling{"hpa", "Pa", 100},
    Spelling{"psi", "kPa", 6.894757293168},

    Spelling{"watt", "W"},
    Spelling{"watts", "W"},
    Spelling{"kilowatt", "kW"},
    Spelling{"kilowatts", "kW"},
    Spelling{"megawatt", "kW", 1000},
    Spelling{"milliwatt", "mW"},
    Spelling{"milliwatts", "mW"},
    Spelling{"j/s", "W"},
    Spelling{"hp", "W", 745.69987158227},
    Spelling{"joule", "J"},
    Spelling{"joules", "J"},
    Spelling{"kilojoules", "kJ"},
    Spelling{"megajoules", "MJ"},
    Spelling{"watthour", "Wh"},
    Spelling{"watthours", "Wh"},
    Spelling{"watt-hours", "Wh"},
    Spelling{"whr", "Wh"},
    Spelling{"w-h", "Wh"},
    Spelling{"kwhr", "kWh"},
    Spelling{"kw-h", "kWh"},
    Spelling{"kilowatthour", "kWh"},
    Spelling{"kilowatthours", "kWh"},
    Spelling{"kilowatt-hours", "kWh"},
    Spelling{"cal", "J", 4.184},
    Spelling{"kcal", "kJ", 4.184},

    Spelling{"percent", "%"},
    Spelling{"pct", "%"},
    Spelling{"pc", "%"},
    Spelling{"prozent", "%"},
    Spelling{"\u2030", "%", 0.1},
    Spelling{"kelvin", "K"},
    Spelling{"kelvins", "K"},
};

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return small;
}

// Removes or unifies what is written in several forms.
std::string bare(std::string text) {
  constexpr std::pair<const char*, const char*> spellings[] = {
      {"\u00b2", "2"}, {"\u00b3", "3"}, {"\u207b\u00b9", "-1"}, {"^", ""},
      {" per ", "/"},  {" / ", "/"},    {"\u00b7", ""},         {"*", ""},
      {".", ""},       {" ", ""}};
  for (const auto& [from, to] : spellings) text = replaced(std::move(text), from, to);
  return text;
}

bool is_of_kind(std::string_view symbol, std::string_view kind) {
  const Unit* unit = find_unit(symbol);
  return unit != nullptr && unit->kind == kind;
}

std::optional<UnitSpelling> found_in(std::span<const Spelling> table, std::string_view word,
                                     std::string_view kind) {
  for (const Spelling& each : table) {
    if (each.word != word || !is_of_kind(each.symbol, kind)) continue;
    return UnitSpelling{std::string(each.symbol), each.factor};
  }
  return {};
}

// Finds a word with one wrong letter, such as "feat". The first letter must be right, since it may
// be a prefix, and words under four letters are not matched, since they could be another unit.
std::optional<UnitSpelling> misspelt(std::string_view small, std::string_view kind) {
  constexpr std::size_t letters_min = 4;
  const bool is_word = small.size() >= letters_min &&
                       std::ranges::all_of(small, [](char c) { return c >= 'a' && c <= 'z'; });
  if (!is_word) return {};
  for (const Spelling& each : words) {
    const bool may_be = each.factor == 1 && each.word.size() >= letters_min &&
                        each.word.front() == small.front() && is_of_kind(each.symbol, kind);
    if (may_be && edit_distance(small, each.word) == 1) {
      return UnitSpelling{std::string(each.symbol), 1};
    }
  }
  return {};
}

// Whether a leading m may be milli or mega, as in "mw", where a capital does not decide. Lengths,
// speeds and durations have no mega in use.
bool may_be_milli_or_mega(std::string_view small, std::string_view kind) {
  return small.front() == 'm' && kind != "length" && kind != "speed" && kind != "duration";
}

}  // namespace

std::optional<UnitSpelling> spelled_unit(std::string_view word, std::string_view kind) {
  if (is_of_kind(word, kind)) return UnitSpelling{std::string(word), 1};
  const std::string plain = bare(std::string(word));
  if (is_of_kind(plain, kind)) return UnitSpelling{plain, 1};
  if (auto found = found_in(exact, plain, kind)) return found;
  const std::string small = in_small_letters(plain);
  if (auto found = found_in(words, small, kind)) return found;
  if (auto found = misspelt(small, kind)) return found;
  if (small.empty() || may_be_milli_or_mega(small, kind)) return {};
  for (const Unit& unit : all_units()) {
    if (unit.kind != kind || in_small_letters(bare(std::string(unit.symbol))) != small) continue;
    return UnitSpelling{std::string(unit.symbol), 1};
  }
  return {};
}

}  // namespace lsos
