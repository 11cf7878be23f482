#include "interchange/imported_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
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
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Start of the mission, by the first row that says it; absent where none does, or wrongly.
std::optional<Instant> mission_start(const std::vector<TypedRow>& rows) {
  for (const TypedRow& row : rows) {
    if (row.type != "MissionInfo") continue;
    const Parsed<std::string> text = utc_text(row.columns->text(*row.row, "StartTime"), {});
    if (!text) continue;
    if (const Parsed<Instant> start = parse_utc(*text.value)) return start.value;
  }
  return {};
}

// Whether a sheet can hold nothing of a plan.
bool is_foreign(const Table& table, const Declarations& declarations) {
  if (!table.has_letters || !name_meant(table.name, declarations).empty()) return false;
  Faults unused;
  const Columns columns(table, declarations, unused);
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

}  // namespace

ImportedPlan import_tables(std::vector<Table> tables, const Declarations& declarations,
                           Faults& faults, ImportedRows rows_are) {
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
  for (std::size_t i = 0; i < used.size(); ++i) {
    for (TypedRow& row :
         typed_rows(*used[i], columns[i], declarations, wanted, places, plan.left_out, faults)) {
      rows.push_back(std::move(row));
    }
    if (!used[i]->body.empty()) {
      plan.source.layers.push_back({used[i]->file, used[i]->body, used[i]->is_geographic});
    }
  }
  // Rows of events stay in their order, which their numbers and times follow.
  std::ranges::stable_sort(rows, {}, [](const TypedRow& row) {
    const std::string_view first[] = {"MissionInfo", "Rover", "Asset"};
    return std::ranges::find(first, row.type) - std::ranges::begin(first);
  });
  Faults repeated;  // own_geometry() reports the same faults again when the row is read
  add_owners("Asset", rows, places, repeated);  // rovers may start at one
  add_owners("Rover", rows, places, repeated);
  if (!tables.empty()) plan.source.file = tables.front().file;
  RowPlacemarks made =
      placemarks_of(rows, declarations, places, mission_start(rows), notes, faults);
  plan.source.placemarks = std::move(made.placemarks);
  if (rows_are == ImportedRows::changes) {
    report_unnumbered(plan.source, faults);
  } else {
    number_events(plan.source, faults);
    begin_lines_at_rovers(made.ways, declarations, plan.source);
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
