#include "interchange/sheet_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>

#include "base/units.h"
#include "interchange/columns.h"
#include "interchange/event_days.h"
#include "interchange/places.h"
#include "interchange/thing_fields.h"
#include "interchange/value_text.h"

namespace lsos {

namespace {

// "Activity Duration" of ActivityDuration.
std::string in_words(const std::string& name) {
  std::string words;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins_word = i > 0 && std::isupper(static_cast<unsigned char>(name[i])) != 0 &&
                             std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    if (begins_word) words += ' ';
    words += name[i];
  }
  return words;
}

class SheetMaker {
 public:
  SheetMaker(const KmlSource& things, const Declarations& declarations,
             const std::vector<Landmark>& landmarks, bool is_one)
      : things_(things),
        declarations_(declarations),
        places_(things, declarations, landmarks),
        days_(event_days(things, declarations)),
        is_one_(is_one) {}

  std::vector<Table> tables() {
    std::vector<std::size_t> parts[4];
    for (std::size_t i = 0; i < things_.placemarks.size(); ++i) {
      const std::string& type = thing_type(things_.placemarks[i]);
      const int part = type == "MissionInfo" ? 0 : type == "Rover" ? 1 : type == "Asset" ? 2 : 3;
      parts[is_one_ ? 3 : part].push_back(i);
    }
    const char* const names[] = {"Mission", "Rovers", "Assets", "Events"};
    std::vector<Table> tables;
    for (int part = 0; part < 4; ++part) {
      if (part == 3 && !is_one_) add_places(tables);
      if (parts[part].empty()) continue;
      tables.push_back(table_of(is_one_ ? "plan" : names[part], parts[part]));
    }
    return tables;
  }

 private:
  // A column: its header, the name that import gives it, and the unit of its numbers.
  struct SheetColumn {
    std::string header, name;
    const Unit* unit = nullptr;
  };

  void add_places(std::vector<Table>& tables) const {
    if (places_.used().empty()) return;
    Table table;
    table.name = "Places";
    table.header = {"Name", column::lon, column::lat};
    table.numbers = {1, 2};
    for (const BookedPlace& place : places_.used()) {
      table.rows.push_back(
          {static_cast<int>(table.rows.size()) + 1, {place.name, place.lon, place.lat}});
    }
    tables.push_back(std::move(table));
  }

  Table table_of(const std::string& name, const std::vector<std::size_t>& things) {
    Table table;
    table.name = name;
    const std::vector<SheetColumn> columns = columns_of(name, things);
    for (const SheetColumn& column : columns) {
      const bool is_degrees = column.name == column::lon || column.name == column::lat;
      if (is_degrees || is_number(column.name, things)) table.numbers.insert(table.header.size());
      table.header.push_back(column.header);
    }
    const auto add = [&](auto&& cell_of) {
      TableRow row{static_cast<int>(table.rows.size()) + 1, {}};
      for (const SheetColumn& column : columns) row.cells.push_back(cell_of(column));
      table.rows.push_back(std::move(row));
    };
    bool has_places = !is_one_;
    for (const std::size_t i : things) {
      // Places stand before the first event.
      if (!has_places && declarations_.events.contains(thing_type(things_.placemarks[i]))) {
        has_places = true;
        for (const BookedPlace& place : places_.used()) {
          add([&](const SheetColumn& column) { return place_cell(place, column); });
        }
      }
      add([&](const SheetColumn& column) { return cell(i, column); });
    }
    return table;
  }

  std::vector<SheetColumn> columns_of(const std::string& sheet,
                                      const std::vector<std::size_t>& things) const {
    // What identifies a row comes first, what is long last.
    std::vector<std::string> names;
    if (is_one_ || sheet == "Events") names = {column::type};
    if (!is_one_ && sheet != "Events") names = {"RoverId", "RoverType", "AssetId", "AssetType"};
    for (const char* first : {"RoverId", "Sequence", column::name, column::day, "StartTime",
                              column::place, column::lon, column::lat}) {
      if (std::ranges::find(names, first) == names.end()) names.emplace_back(first);
    }
    const auto add = [&](const auto& fields) {
      for (const FieldDeclaration& field : fields) {
        if (std::ranges::find(names, field.name) == names.end()) names.push_back(field.name);
      }
    };
    // Fields of events in the order of their first use, those of all events last.
    for (const bool is_event : {true, false}) {
      for (const std::size_t i : things) {
        const auto event = declarations_.events.find(thing_type(things_.placemarks[i]));
        if (is_event && event != declarations_.events.end()) add(event->second.fields);
        if (is_event || event != declarations_.events.end()) continue;
        for (const auto& list : fields_of(thing_type(things_.placemarks[i]), declarations_)) {
          add(list);
        }
      }
    }
    add(common_event_fields());
    names.insert(names.end(), {column::wkt, column::description});
    std::vector<SheetColumn> columns;
    for (const std::string& name : names) {
      SheetColumn column{name, name, nullptr};
      if (!is_filled(column, things)) continue;
      column.unit = unit_of(name, things);
      column.header = header_of(name, column.unit);
      columns.push_back(std::move(column));
    }
    return columns;
  }

  bool is_filled(const SheetColumn& column, const std::vector<std::size_t>& things) const {
    const bool is_of_place =
        column.name == column::name || column.name == column::lon || column.name == column::lat;
    if (is_of_place && is_one_ && !places_.used().empty()) return true;
    return std::ranges::any_of(things, [&](std::size_t i) { return !cell(i, column).empty(); });
  }

  // The header that people read, where import reads it as that name.
  std::string header_of(const std::string& name, const Unit* unit) const {
    static const std::map<std::string, std::string> everyday{{"RoverId", "Rover"},
                                                             {"StartTime", "Start"},
                                                             {column::name, "Name"},
                                                             {column::description, "Notes"}};
    const auto found = everyday.find(name);
    std::string header = found == everyday.end() ? in_words(name) : found->second;
    if (column_meant(header, declarations_) != name) header = name;
    const bool is_said = unit != nullptr && unit->symbol != "1";
    return is_said ? fmt::format("{} ({})", header, unit->symbol) : header;
  }

  const Unit* unit_of(const std::string& name, const std::vector<std::size_t>& things) const {
    std::vector<DeclaredText> texts;
    for (const std::size_t i : things) {
      const SourcePlacemark& thing = things_.placemarks[i];
      const std::string* text = thing_field(thing, name);
      const FieldDeclaration* field = declared_field(thing_type(thing), name, declarations_);
      if (text == nullptr) continue;
      if (field == nullptr) return nullptr;
      texts.emplace_back(field, *text);
    }
    return shortest_unit(texts);
  }

  // Whether a column is a field, and a number of all things that have it.
  bool is_number(const std::string& name, const std::vector<std::size_t>& things) const {
    bool is_field = false;
    for (const std::size_t i : things) {
      const SourcePlacemark& thing = things_.placemarks[i];
      if (thing_field(thing, name) == nullptr) continue;
      is_field = true;
      const FieldDeclaration* field = declared_field(thing_type(thing), name, declarations_);
      const bool is_one = field != nullptr &&
                          (field->kind == FieldKind::number || field->kind == FieldKind::integer ||
                           field->kind == FieldKind::duration);
      if (!is_one) return false;
    }
    return is_field;
  }

  static std::string place_cell(const BookedPlace& place, const SheetColumn& column) {
    if (column.name == column::type) return "Place";
    if (column.name == column::name) return place.name;
    if (column.name == column::lon) return place.lon;
    return column.name == column::lat ? place.lat : "";
  }

  std::string cell(std::size_t i, const SheetColumn& column) const {
    const SourcePlacemark& thing = things_.placemarks[i];
    const std::string& name = column.name;
    if (name == column::type) return thing_type(thing);
    if (name == column::name) return thing.name;
    if (name == column::description) return thing.description;
    if (name == column::place) return places_.text(i);
    const int day = days_.empty() ? 0 : days_[i].day;
    if (name == column::day) return day == 0 ? "" : std::to_string(day);
    if (name == column::lon || name == column::lat || name == column::wkt) {
      return geometry_cell(i, name);
    }
    const std::string* text = thing_field(thing, name);
    if (text == nullptr) return "";
    if (name == "StartTime" && day > 0) return days_[i].start;
    const FieldDeclaration* field = declared_field(thing_type(thing), name, declarations_);
    if (field == nullptr) return *text;
    const bool is_time = field->kind == FieldKind::utc || field->kind == FieldKind::moment;
    if (is_time && day > 0) return time_on_day(*text, day, things_);
    return column.unit == nullptr ? *text : text_in_unit(*text, *field, *column.unit);
  }

  std::string geometry_cell(std::size_t i, const std::string& name) const {
    const SourcePlacemark& thing = things_.placemarks[i];
    if (thing.geometries.empty() || !places_.text(i).empty()) return "";
    const SourceGeometry& geometry = thing.geometries.front();
    if (name == column::wkt) return geometry.kind == "Point" ? "" : wkt_of(geometry);
    if (geometry.kind != "Point") return "";
    const std::string& tuple = geometry.coordinates;
    const std::size_t comma = tuple.find(',');
    const std::size_t end = std::min(tuple.find(',', comma + 1), tuple.size());
    return name == column::lon ? tuple.substr(0, comma) : tuple.substr(comma + 1, end - comma - 1);
  }

  const KmlSource& things_;
  const Declarations& declarations_;
  PlaceBook places_;
  std::vector<EventDay> days_;
  bool is_one_;
};

}  // namespace

std::vector<Table> sheet_tables(const KmlSource& things, const Declarations& declarations,
                                const std::vector<Landmark>& landmarks, bool is_one) {
  return SheetMaker(things, declarations, landmarks, is_one).tables();
}

}  // namespace lsos
