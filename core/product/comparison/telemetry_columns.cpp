#include "product/comparison/telemetry_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/quantity.h"
#include "base/quantity_advice.h"
#include "base/replaced.h"
#include "base/text.h"
#include "base/unit_spellings.h"

namespace lsos {

namespace {

// What a column may have: a quantity, or one of the columns that say when, who and where.
struct Target {
  TelemetryKind kind = TelemetryKind::quantity;
  const MeasuredQuantity* quantity = nullptr;
  std::string name;       // as the log has it: "speed_mps"
  std::string base;       // "speed"
  std::string_view unit;  // kind of unit; "" for a text
};

const std::vector<Target>& targets() {
  static const std::vector<Target> all = [] {
    std::vector<Target> list;
    for (const char* base : {"time", "elapsed", "elapsed_time"}) {
      list.push_back({TelemetryKind::time, nullptr, "time_s", base, "duration"});
    }
    for (const char* base : {"utc", "time_utc", "utc_time", "time,_utc", "time_(utc)"}) {
      list.push_back({TelemetryKind::utc, nullptr, "utc", base, ""});
    }
    for (const char* base : {"rover_id", "rover", "roverid"}) {
      list.push_back({TelemetryKind::rover, nullptr, "rover_id", base, ""});
    }
    for (const char* base : {"lon", "longitude", "lng"}) {
      list.push_back({TelemetryKind::lon, nullptr, "lon_deg", base, "angle"});
    }
    for (const char* base : {"lat", "latitude"}) {
      list.push_back({TelemetryKind::lat, nullptr, "lat_deg", base, "angle"});
    }
    // Columns of the log, exported with the others, that have no numbers to compare.
    for (const char* base : {"event", "phase", "fid", "geom", "wkt"}) {
      list.push_back({TelemetryKind::ignored, nullptr, base, base, ""});
    }
    for (const MeasuredQuantity& quantity : measured_quantities()) {
      const std::string_view unit = quantity.unit->kind;
      list.push_back({TelemetryKind::quantity, &quantity, quantity.name, quantity.base, unit});
    }
    return list;
  }();
  return all;
}

// In small letters, with '_' for blanks.
std::string key(std::string_view text) {
  std::string small(trimmed(text));
  for (char& c : small) {
    c = c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return small;
}

// A heading taken apart: "Speed (km/h)" is speed in km/h.
struct Parts {
  std::string base, unit;
};

// All ways to take it apart; the whole of it comes first.
std::vector<Parts> all_parts(std::string_view heading) {
  std::vector<Parts> all{{key(heading), ""}};
  for (const std::string_view brackets : {"()", "[]"}) {
    const std::size_t open = heading.rfind(brackets[0]);
    if (open == std::string_view::npos || !heading.ends_with(brackets[1])) continue;
    const std::string_view unit = heading.substr(open + 1, heading.size() - open - 2);
    all.push_back({key(heading.substr(0, open)), std::string(trimmed(unit))});
  }
  const std::size_t comma = heading.rfind(',');
  if (comma != std::string_view::npos) {
    all.push_back({key(heading.substr(0, comma)), std::string(trimmed(heading.substr(comma + 1)))});
  }
  const std::string joined = replaced(std::string(heading), " ", "_");
  for (std::size_t at = joined.find('_'); at != std::string::npos; at = joined.find('_', at + 1)) {
    const std::string unit = joined.substr(at + 1);
    const bool is_word = !unit.empty() && unit.find_first_of("()[],") == std::string::npos;
    if (is_word) all.push_back({key(joined.substr(0, at)), replaced(unit, "_", "/")});
  }
  return all;
}

// The unit of that kind that is written so, also as the end of a name: "mps", "kmph".
std::optional<UnitSpelling> unit_of_word(const std::string& word, std::string_view kind) {
  for (const Unit& unit : all_units()) {
    const bool is_suffix = unit.kind == kind && unit.si_factor == 1 && unit.suffix == word;
    if (is_suffix && !word.empty()) return UnitSpelling{std::string(unit.symbol), 1};
  }
  return spelled_unit(word, kind);
}

// The unit of numbers under a heading that names none; absent where one has to be named.
std::optional<UnitSpelling> unit_unless_named(const Target& target) {
  if (target.unit == "fraction") return UnitSpelling{"1", 1};
  if (target.kind == TelemetryKind::lon || target.kind == TelemetryKind::lat) {
    return UnitSpelling{"deg", 1};
  }
  return {};
}

std::string example(const Target& target) {
  std::string word = target.base;
  word.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(word.front())));
  std::string_view symbol;
  for (const Unit& unit : all_units()) {
    if (unit.kind == target.unit && unit.si_factor != 1 && symbol.empty()) symbol = unit.symbol;
  }
  return fmt::format("'{}' or '{} ({})'", target.name, replaced(word, "_", " "), symbol);
}

void set(TelemetryColumn& column, const Target& target, const UnitSpelling& unit) {
  column.kind = target.kind;
  column.quantity = target.quantity;
  column.unit = find_unit(unit.symbol);
  column.factor = unit.factor;
}

// The nearest name, by the names without units: "Sped (km/h)" may be speed_mps.
std::string name_advice(const std::vector<Parts>& parts) {
  const Target* nearest = nullptr;
  int least = 0;
  for (const Target& target : targets()) {
    for (const Parts& part : parts) {
      const int distance = edit_distance(part.base, target.base);
      const int most = std::max(1, static_cast<int>(target.base.size()) / 3);
      if (distance > most || target.base.size() < 3) continue;
      if (nearest != nullptr && distance >= least) continue;
      nearest = &target;
      least = distance;
    }
  }
  return nearest != nullptr ? fmt::format("; did you mean '{}'?", nearest->name) : "";
}

}  // namespace

Parsed<double> TelemetryColumn::value(const std::string& cell) const {
  Parsed<double> parsed = parse_quantity(cell, *unit);
  const bool is_bare = factor != 1 && parse_quantity(cell, *find_unit("1")) && !cell.ends_with('%');
  if (parsed && is_bare) *parsed.value *= factor;
  return parsed;
}

TelemetryColumn telemetry_column(const std::string& heading) {
  TelemetryColumn column;
  column.heading = heading;
  if (heading.empty()) {
    column.kind = TelemetryKind::ignored;  // as behind a separator at the ends of lines
    return column;
  }
  const std::vector<Parts> parts = all_parts(heading);
  for (const Target& target : targets()) {
    const bool is_name =
        key(heading) == target.name || (target.unit.empty() && key(heading) == target.base);
    const bool is_title = target.quantity != nullptr && key(heading) == key(target.quantity->title);
    if (!is_name && !is_title) continue;
    std::string_view symbol = "1";
    if (target.quantity != nullptr) symbol = target.quantity->unit->symbol;
    if (target.kind == TelemetryKind::time) symbol = "s";
    if (target.unit == "angle" && target.quantity == nullptr) symbol = "deg";
    set(column, target, {std::string(symbol), 1});
    return column;
  }
  std::string fault;
  for (const Parts& part : parts) {
    for (const Target& target : targets()) {
      if (target.unit.empty() || part.base != target.base) continue;
      const std::optional<UnitSpelling> unit =
          part.unit.empty() ? unit_unless_named(target) : unit_of_word(part.unit, target.unit);
      if (unit) {
        set(column, target, *unit);
        return column;
      }
      if (part.unit.empty()) {
        fault = fmt::format("has no unit; {} is allowed", example(target));
      } else if (const Unit* other = find_unit(part.unit)) {
        fault = fmt::format("'{}' is a unit of {}, a {} is wanted, as in {}", part.unit,
                            other->kind, target.unit, example(target));
      } else {
        fault = fmt::format("there is no unit '{}' of {}{}", part.unit, target.unit,
                            unit_advice(part.unit, target.unit));
      }
    }
  }
  column.fault = !fault.empty() ? fault : "a run logs no such quantity" + name_advice(parts);
  return column;
}

std::vector<TelemetryColumn> telemetry_columns(const std::vector<std::string>& headings) {
  std::vector<TelemetryColumn> columns;
  for (const std::string& heading : headings) {
    TelemetryColumn column = telemetry_column(heading);
    const auto same = std::ranges::find_if(columns, [&](const TelemetryColumn& other) {
      return other.kind == column.kind && other.quantity == column.quantity;
    });
    const bool may_repeat =
        column.kind == TelemetryKind::ignored || column.kind == TelemetryKind::unusable;
    if (!may_repeat && same != columns.end()) {
      column.fault = fmt::format("gives again what column '{}' gives", same->heading);
      column.kind = TelemetryKind::unusable;
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace lsos
