#include "interchange/imported_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <iterator>
#include <optional>
#include <set>

#include "interchange/clock_text.h"
#include "interchange/columns.h"
#include "interchange/header_row.h"
#include "interchange/places.h"
#include "interchange/rover_places.h"
#include "interchange/row_placemarks.h"
#include "interchange/row_types.h"
#include "interchange/sequences.h"
#include "interchange/thing_fields.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Start of the mission, by the first row that says it.
SheetStart mission_start(const std::vector<TypedRow>& rows) {
  SheetStart start;
  for (const TypedRow& row : rows) {
    if (row.type != "MissionInfo" || row.text("StartTime").empty()) continue;
    start.is_said = true;
    const Parsed<std::string> text = utc_text(row.text("StartTime"), {});
    if (!text) continue;
    start.instant = parse_utc(*text.value).value;
    if (start.instant) break;
  }
  return start;
}

// Whether a sheet can hold nothing of a plan.
bool is_foreign(const Table& table, const Declarations& declarations) {
  if (!table.has_letters || !type_of_sheet(table, declarations).empty()) return false;
  Faults unused;
  const Columns columns(table, declarations, unused);
  if (columns.has_unknown_crs()) return false;
  for (const char* name : {column::type, column::lon, column::lat, column::wkt, "RoverId"}) {
    if (columns.find(name) != nullptr) return false;
  }
  return true;
}

// Rovers or assets are places by their ids and names.
void add_owners(const std::string& type, const std::vector<TypedRow>& rows, PlaceNames& places,
                Faults& faults) {
  for (const TypedRow& row : rows) {
    if (row.type != type) continue;
    SourceGeometry geometry = own_geometry(*row.table, *row.row, *row.columns, faults);
    const std::string named = row.columns->text(*row.row, column::place);
    if (geometry.kind.empty() && !named.empty()) {
      geometry = places.geometry(named).value.value_or(SourceGeometry{});
    }
    if (geometry.kind.empty()) continue;
    const std::string id = row.columns->text(*row.row, row.type + "Id");
    for (const std::string& name : {id, row.columns->text(*row.row, column::name)}) {
      if (!name.empty() && !places.has_exactly(name)) {
        places.add(name, {geometry, {row.table->file, row.row->number}, true, true});
      }
    }
  }
}

// The named Points of a drawn plan are places for rows, but where a sheet has one of that name.
void add_drawn_places(const DrawnPlan& drawn, PlaceNames& places, ImportedPlan& plan,
                      Notes& notes) {
  for (const Landmark& each : drawn.places) {
    const auto is_called_so = [&](const Landmark& other) { return other.name == each.name; };
    const bool is_sole = std::ranges::count_if(drawn.places, is_called_so) == 1;
    const SourceGeometry point{"Point", each.coordinates, 0};
    if (!places.has_exactly(each.name)) {
      const std::string other = places.name_at(place_key(each.coordinates));
      if (!other.empty()) {
        notes.add(fmt::format("the place {} is where the plan has {}, which keeps its name",
                              quoted(other), quoted(each.name)));
      }
      places.add(each.name, {point, {drawn.things.file, 0}, true, true});
      continue;
    }
    const std::string now = places.point(each.name);
    if (now.empty() || place_key(now) == place_key(each.coordinates)) continue;
    if (is_sole) {
      plan.moved_places.push_back({each, now});
    } else {
      notes.add(fmt::format("the plan has several places {}, which stay where they are",
                            quoted(each.name)));
    }
  }
}

std::set<ThingId> ids_of(const DrawnPlan* drawn) {
  std::set<ThingId> ids;
  if (drawn == nullptr) return ids;
  for (const SourcePlacemark& thing : drawn->things.placemarks) {
    ids.insert(thing_id(thing.data.front()));
  }
  return ids;
}

}  // namespace

ImportedPlan import_tables(std::vector<Table> tables, const Declarations& declarations,
                           Faults& faults, const DrawnPlan* drawn) {
  ImportedPlan plan;
  Notes notes;
  for (Table& table : tables) {
    const std::string note = find_header(table, declarations);
    if (!note.empty()) notes.add(note);
  }
  PlaceNames places;
  std::deque<Columns> columns;
  std::vector<TypedRow> rows;
  std::set<std::string> wanted;
  std::vector<const Table*> used;
  for (const Table& table : tables) {
    if (is_foreign(table, declarations)) {
      plan.left_out.push_back(
          fmt::format("{}: a sheet with neither a column Type nor places", table.file));
      continue;
    }
    used.push_back(&table);
    columns.emplace_back(table, declarations, faults);
    wanted.merge(wanted_places(table, columns.back()));
  }
  bool are_untyped = false;
  for (std::size_t i = 0; i < used.size(); ++i) {
    TypedRows typed =
        typed_rows(*used[i], columns[i], declarations, wanted, places, plan.left_out, faults);
    are_untyped |= typed.are_none;
    std::ranges::move(typed.rows, std::back_inserter(rows));
    if (!used[i]->body.empty()) {
      plan.source.layers.push_back({used[i]->file, used[i]->body, used[i]->is_geographic});
    }
  }
  // Missing rovers and assets would only follow from it.
  if (are_untyped) faults.throw_if_errors();
  // Rows of events stay in their order, which their numbers and times follow.
  std::ranges::stable_sort(rows, {}, [](const TypedRow& row) {
    const std::string_view first[] = {"MissionInfo", "Rover", "Asset"};
    return std::ranges::find(first, row.type) - std::ranges::begin(first);
  });
  if (drawn != nullptr) add_drawn_places(*drawn, places, plan, notes);
  Faults repeated;  // own_geometry() reports the same faults again when the row is read
  add_owners("Asset", rows, places, repeated);  // rovers may start at one
  add_owners("Rover", rows, places, repeated);
  if (!tables.empty()) plan.source.file = tables.front().file;
  RowPlacemarks made =
      placemarks_of(rows, declarations, places, mission_start(rows), ids_of(drawn), notes, faults);
  plan.source.placemarks = std::move(made.placemarks);
  plan.ways = std::move(made.ways);
  if (drawn != nullptr) {
    report_unnumbered(plan.source, faults);
  } else {
    number_events(plan.source, faults);
    begin_lines_at_rovers(plan.ways, declarations, plan.source);
  }
  if (const std::vector<std::string> unused = places.unused(); !unused.empty()) {
    plan.left_out.push_back(fmt::format("{} place{} that no row names: {}", unused.size(),
                                        unused.size() == 1 ? "" : "s", listed(unused)));
  }
  plan.places = places.used_points();
  for (const std::string& note : places.notes()) notes.add(note);
  plan.notes = notes.all();
  return plan;
}

}  // namespace lsos
