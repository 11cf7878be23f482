#include "lua/edit/import_onto.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/files.h"
#include "edit/editable_file.h"
#include "edit/placemark_edit.h"
#include "edit/plan_thing.h"
#include "edit/put_rows.h"
#include "interchange/imported_plan.h"
#include "interchange/place_book.h"
#include "interchange/plan_tables.h"
#include "interchange/rover_places.h"
#include "lua/edit/change_text.h"
#include "lua/edit/imported_files.h"
#include "lua/edit/kept_ground.h"
#include "lua/edit/new_plan.h"
#include "lua/host/mission_reader.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// The mission, rovers and assets of the plan as a table, so that days are counted from its start
// and places may be called by its rovers and assets where the sheets have only events.
Table owners(const KmlSource& things, const Declarations& declarations) {
  KmlSource some{things.file, {}};
  for (const SourcePlacemark& thing : things.placemarks) {
    const std::optional<ThingKey> key = key_of(thing);
    if (key && key->kind != ThingKey::Kind::event) some.placemarks.push_back(thing);
  }
  Table table = plan_tables(some, declarations, TableDivision::none, true).front();
  table.file = things.file;
  return table;
}

// A sheet that has nothing in common with the plan is that of another one.
void check_kinship(const OntoResult& result, const Plan& plan, const OntoOptions& options) {
  const RowChanges& changes = result.changes;
  if (!result.moved_places.empty() && changes.added.empty()) return;
  const auto without_row =
      static_cast<std::size_t>(std::ranges::count_if(changes.without_row, [](const ThingKey& key) {
        return key.kind != ThingKey::Kind::mission;
      }));
  const bool has_match = without_row < plan.rovers.size() + plan.assets.size() + plan.events.size();
  const bool has_rover = std::ranges::any_of(changes.added, [&](const RowChange& row) {
    return row.key.kind == ThingKey::Kind::event && rover_of(plan, row.key.id) != nullptr;
  });
  if (has_match || has_rover) return;
  std::vector<std::string> ids;
  for (const PlanRover& rover : plan.rovers) ids.push_back(rover.id);
  throw InputError({options.files.front(), 0},
                   fmt::format("none of its {} rows is of a rover, an asset or an event of {}, "
                               "whose rovers are {}; is it the sheet of another plan?",
                               changes.added.size(), options.plan, fmt::join(ids, ", ")));
}

void check_files(const OntoOptions& options) {
  for (const std::string& file : options.files) {
    std::error_code absent;
    if (std::filesystem::equivalent(file, options.plan, absent)) {
      throw InputError({}, fmt::format("--onto {}: is the file that is imported, too; a sheet or "
                                       "map with changes of it is wanted",
                                       options.plan));
    }
  }
}

// The first row of a day begins at midnight where it says no time. In a sheet that has no column of
// times it is the drawn event's own that counts.
void keep_times_without_column(const KmlSource& things,
                               const std::map<std::string, SheetColumns>& columns,
                               std::vector<SourcePlacemark>& rows) {
  const auto is_drawn = [&](const SourcePlacemark& row) {
    return std::ranges::any_of(things.placemarks, [&](const SourcePlacemark& thing) {
      return field_of(thing, "RoverId") == field_of(row, "RoverId") &&
             field_of(thing, "Sequence") == field_of(row, "Sequence");
    });
  };
  for (SourcePlacemark& row : rows) {
    const auto sheet = columns.find(row.file);
    if (sheet == columns.end() || sheet->second.names.contains("StartTime")) continue;
    if (field_of(row, "StartTime").empty() || !is_drawn(row)) continue;
    for (SourceData& data : row.data) {
      std::erase_if(data.fields,
                    [](const SourceField& field) { return field.name == "StartTime"; });
    }
  }
}

// Takes out the rows of owners(), which are no changes.
void erase_owners(const KmlSource& things, ImportedPlan& made) {
  auto& rows = made.source.placemarks;
  const auto is_owner = [&](const SourcePlacemark& row) { return row.file == things.file; };
  for (std::size_t& way : made.ways) {
    way -= static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(way), is_owner));
  }
  std::erase_if(rows, is_owner);
}

// Lets lines to places by name begin where the rover stands among all events of the plan.
// `changes`: of the rows, which are the first Placemarks of the merged plan.
void begin_ways(const RowChanges& changes, const Declarations& declarations, ImportedPlan& made) {
  KmlSource merged = changes.merged;
  begin_lines_at_rovers(made.ways, declarations, merged);
  for (const std::size_t way : made.ways) {
    auto& geometries = made.source.placemarks[way].geometries;
    if (!geometries.empty()) geometries = merged.placemarks[way].geometries;
  }
}

}  // namespace

std::string import_onto(const OntoOptions& options) {
  check_files(options);
  const MissionFiles files = read_mission(options.plan);
  files.faults.throw_if_errors();
  const EditableFile file(files.plan_bytes, options.plan);
  const char* ending = file.is_kmz() ? ".kmz" : ".kml";
  if (!options.output.ends_with(ending)) {
    throw InputError({}, fmt::format("-o {}: the name must end in {}, as the plan is that",
                                     options.output, ending));
  }
  const Declarations& declarations = files.catalog->declarations();
  const KmlSource source = parse_kml(file.kml(), options.plan);
  const DrawnPlan drawn{plan_things(source, declarations), landmarks(source, declarations)};
  const KmlSource& things = drawn.things;

  OntoResult result;
  std::vector<Table> tables = read_all_tables(options.files, declarations, result.left_out);
  const auto columns = sheet_columns(tables, declarations);
  const std::set<ThingKey::Kind> kinds = kinds_of_sheets(tables, declarations);
  tables.push_back(owners(things, declarations));
  Faults faults;
  ImportedPlan made = import_tables(tables, declarations, faults, &drawn);
  result.left_out.insert(result.left_out.end(), made.left_out.begin(), made.left_out.end());
  result.notes = made.notes;
  result.moved_places = made.moved_places;
  erase_owners(things, made);
  keep_times_without_column(things, columns, made.source.placemarks);

  const auto changes_of_rows = [&] {
    RowChanges changes = row_changes(things, made.source.placemarks, columns, declarations);
    result.removable = removable(changes, made.source.placemarks, kinds);
    if (options.removes_missing) leave_out(changes, result.removable);
    return changes;
  };
  begin_ways(changes_of_rows(), declarations, made);
  result.changes = changes_of_rows();
  if (!faults.has_errors()) check_kinship(result, files.plan, options);
  if (options.removes_missing) result.removed = std::move(result.removable);
  if (options.removes_missing) result.removable.clear();
  result.changes.merged.layers = made.source.layers;
  const MissionFiles wanted = read_mission(
      PlanSource{options.plan, result.changes.merged, "", files.plan_bytes, true}, files.catalog);
  faults.add(placing_faults(wanted));
  faults = in_words_for_sheets(with_plan_faults(faults, wanted.faults));
  tell_left_out(faults, result.left_out);
  faults.throw_if_errors();

  PlanDocument document(file.kml(), files.plan, declarations);
  const std::string text_before = document.text();
  // Points are found by their index, which new Placemarks would change.
  for (const MovedPlace& each : result.moved_places) {
    move_point(document, each.place.index, each.coordinates);
  }
  put_rows(document, result.changes, result.removed);
  Faults none;
  const Plan edited =
      read_plan(options.plan, parse_kml(document.text(), options.plan), declarations, none);
  // What was checked is what is written.
  LSOS_ASSERT(none.has_errors() || edited.hash() == wanted.plan.hash());
  if (const std::string kept = keep_ground(document, files); !kept.empty()) {
    result.notes.push_back(kept);
  }
  document.follow_rasters(options.output);
  // A document that says the same stays as it was to the last byte.
  const bool is_same = document.text() == text_before;
  const std::string bytes = is_same ? files.plan_bytes : file.with(document.text());
  const MissionFiles new_files = read_new_plan(bytes, options.output);
  write_file(options.output, bytes);
  tell_new_warnings(files.faults, faults);
  result.plan_sha256 = new_files.plan.hash();
  return options.is_json ? onto_json(result, options.output) : onto_text(result, options.output);
}

}  // namespace lsos
