#include "interchange/row_placemarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/quantity.h"
#include "base/replaced.h"
#include "interchange/cell_text.h"
#include "interchange/decimals.h"
#include "interchange/names_in_any_case.h"
#include "interchange/row_times.h"
#include "interchange/thing_fields.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

bool is_special(const std::string& name) {
  for (const char* each : {column::type, column::name, column::description, column::day,
                           column::place, column::lon, column::lat, column::wkt}) {
    if (name == each) return true;
  }
  return false;
}

bool is_time(const FieldDeclaration& field) {
  return field.kind == FieldKind::utc || field.kind == FieldKind::moment;
}

// Makes Placemarks of rows, in their order.
class PlacemarkMaker {
 public:
  PlacemarkMaker(const std::vector<TypedRow>& rows, const Declarations& declarations,
                 const PlaceNames& places, SheetStart start, const std::set<ThingId>& drawn,
                 Notes& notes, Faults& faults)
      : declarations_(declarations),
        places_(places),
        drawn_(drawn),
        times_(start, notes, faults),
        notes_(notes),
        faults_(faults) {
    for (const TypedRow& row : rows) {
      if (row.type != "Rover" && row.type != "Asset") continue;
      const std::string id = row.columns->text(*row.row, row.type + "Id");
      if (id.empty()) continue;
      owners_.push_back(id);
      if (row.type == "Rover") rovers_.push_back(id);
    }
  }

  // Whether the last row drives to several places by name.
  bool is_way() const { return is_way_; }

  SourcePlacemark placemark(const TypedRow& from) {
    from_ = &from;
    placemark_ = {};
    placemark_.file = from.table->file;
    placemark_.line = from.row->number;
    placemark_.name = text(column::name);
    placemark_.description = text(column::description);
    data_ = {"", from.type, {}, from.row->number};
    is_event_ = declarations_.events.contains(from.type);
    if (is_event_) {
      begin_event();
    } else {
      times_.begin(from);
    }
    add_fields();
    if (is_event_) end_event();
    sort_fields();
    add_geometry();
    placemark_.data.push_back(std::move(data_));
    return std::move(placemark_);
  }

 private:
  std::string text(const std::string& column) const { return from_->text(column); }
  Place cell_place(const std::string& column) const { return from_->cell_place(column); }
  void add_field(const std::string& name, std::string value) {
    const Place place = cell_place(name);
    data_.fields.push_back({name, std::move(value), place.line, place.column});
  }

  void begin_event() {
    std::string& above = rover_above_[from_->table];
    if (const std::string id = text("RoverId"); !id.empty()) above = meant(id, rovers_);
    rover_id_ = above;
    times_.begin_event(*from_, rover_id_);
    // Other times count from the row's own start.
    const SheetColumn* start = from_->columns->find("StartTime");
    if (start != nullptr && !text("StartTime").empty()) add_column("StartTime", *start);
  }

  // The id that a text means, in any case of letters; the text where it means none.
  std::string meant(const std::string& text, const std::vector<std::string>& ids) {
    const std::string id = name_in_any_case(text, ids);
    if (id.empty() || id == text) return text;
    notes_.add(fmt::format("{} is taken for {}", quoted(text), quoted(id)));
    return id;
  }

  Decimals decimals() {
    const auto known = decimals_.find(from_->table);
    if (known != decimals_.end()) return known->second;
    const Decimals found = decimals_of(*from_->table, *from_->columns, declarations_);
    return decimals_.emplace(from_->table, found).first->second;
  }

  // The text of a field as a plan writes it.
  void add_value(const FieldDeclaration& field, const std::string& cell_text,
                 const SheetColumn& column) {
    const bool is_number = field.kind == FieldKind::number || field.kind == FieldKind::duration ||
                           field.kind == FieldKind::moment;
    Parsed<std::string> number{cell_text, {}};
    if (is_number && from_->table->has_commas) number = with_decimal_point(cell_text, decimals());
    if (!number) {
      faults_.error(cell_place(field.name), fmt::format("{} = {}", field.name, number.why));
      return add_field(field.name, replaced(cell_text, ",", "."));  // read on as a decimal
    }
    if (is_number && column.unit.empty()) note_unit(field, *number.value, column);
    if (field.kind == FieldKind::number && column.unit == "%") {
      warn_of_share(field, *number.value, column);
    }
    add_field(field.name, field_text(*number.value, field, column.unit, from_->table->has_commas));
  }

  // Warns of a number in a column of percents that may be meant as a share.
  void warn_of_share(const FieldDeclaration& field, const std::string& text,
                     const SheetColumn& column) {
    const Parsed<double> value = parse_quantity(text, *find_unit("1"));
    const bool is_bare = text.find_first_not_of("0123456789.+-eE") == std::string::npos;
    if (!is_bare || !value || *value.value <= 0 || *value.value > 1) return;
    faults_.warning(cell_place(field.name),
                    fmt::format("{0} = {1} under {2} is {1} %; for {3:.10g} % write {3:.10g}, or "
                                "'{3:.10g} %'",
                                field.name, text, quoted(from_->table->header.at(column.index)),
                                *value.value * 100));
  }

  // Tells once for a column of a sheet what its numbers without a unit are.
  void note_unit(const FieldDeclaration& field, const std::string& text,
                 const SheetColumn& column) {
    const bool is_bare = text.find_first_not_of("0123456789.+-eE") == std::string::npos;
    const bool is_duration = field.kind != FieldKind::number;
    const bool has_none = !is_duration && (field.unit == nullptr || !field.amount_of.empty());
    if (!from_->table->has_letters || !is_bare || has_none) return;
    const std::string unit(is_duration ? "s" : field.unit->symbol);
    const Place header = place_of_cell(*from_->table, from_->table->header_number, column.index);
    notes_.add(fmt::format("{}:{}{}: column {}: numbers without a unit are {}", header.file,
                           header.column, header.line, from_->table->header.at(column.index),
                           unit == "1" ? "shares, 0.8 for 80 %" : unit));
  }

  void add_fields() {
    for (const auto& [name, column] : from_->columns->all()) {
      if (!is_event_ || name != "StartTime") add_column(name, column);
    }
  }

  void add_column(const std::string& name, const SheetColumn& column) {
    const std::string cell_text = text(name);
    if (is_special(name) || cell_text.empty()) return;
    const FieldDeclaration* field = declared_field(from_->type, name, declarations_);
    // Reported with the names that there are when the plan is read.
    if (field == nullptr) return add_field(name, cell_text);
    if (const std::string why = unit_fault(column.unit, *field); !why.empty()) {
      if (reported_.emplace(from_->table, name).second) {
        faults_.error(place_of_cell(*from_->table, from_->table->header_number, column.index), why);
      }
      return;
    }
    const bool is_id = field->names == NameOf::other || field->names == NameOf::leader ||
                       field->names == NameOf::power_source;
    if (is_time(*field)) {
      add_time(*field, cell_text, column);
    } else if (is_id || (is_event_ && name == "RoverId")) {
      add_field(name, meant(cell_text, is_id ? owners_ : rovers_));
    } else {
      add_value(*field, cell_text, column);
    }
  }

  // Brings the fields into the order of their declarations.
  void sort_fields() {
    std::map<std::string, std::size_t> order;
    for (const auto& list : fields_of(from_->type, declarations_)) {
      for (const FieldDeclaration& each : list) order.emplace(each.name, order.size());
    }
    std::ranges::stable_sort(data_.fields, {}, [&](const SourceField& field) {
      const auto found = order.find(field.name);
      return found == order.end() ? order.size() : found->second;
    });
  }

  void add_time(const FieldDeclaration& field, const std::string& cell_text,
                const SheetColumn& column) {
    // A moment may be a duration from the start, which begins with a digit and has no colon.
    const bool may_be_duration = field.kind == FieldKind::moment &&
                                 cell_text.find(':') == std::string::npos &&
                                 cell_text.find('-') == std::string::npos;
    if (may_be_duration && !cell_text.starts_with('+')) return add_value(field, cell_text, column);
    if (auto time = times_.time(field, cell_text)) add_field(field.name, std::move(*time));
  }

  const SourceField* find(const std::string& name) const {
    const auto found = std::ranges::find(data_.fields, name, &SourceField::name);
    return found == data_.fields.end() ? nullptr : &*found;
  }

  void end_event() {
    if (find("RoverId") == nullptr && !rover_id_.empty()) add_field("RoverId", rover_id_);
    if (find("Sequence") == nullptr) add_field("Sequence", "");  // see number_events()
    if (const auto midnight = times_.end_event()) add_field("StartTime", *midnight);
    if (!rover_id_.empty()) placemark_.folders.push_back(rover_id_);
    if (times_.has_day()) placemark_.folders.push_back(times_.date());
  }

  void add_geometry() {
    const int before = place_faults_;
    is_way_ = false;
    SourceGeometry geometry = place_of_row();
    if (place_faults_ > before) geometry = stand_in();
    if (geometry.kind.empty()) return;
    geometry.line = from_->row->number;
    placemark_.geometries.push_back(std::move(geometry));
  }

  void place_fault(const std::string& what, const std::string& column = column::place) {
    ++place_faults_;
    faults_.error(cell_place(column), what);
  }

  SourceGeometry place_of_row() {
    Faults own;
    SourceGeometry geometry = own_geometry(*from_->table, *from_->row, *from_->columns, own);
    if (own.has_errors()) ++place_faults_;
    faults_.add(own.sorted());
    const std::string named = text(column::place);
    if (!named.empty()) {
      Parsed<SourceGeometry> found = places_.geometry(named);
      if (!geometry.kind.empty()) {
        place_fault(
            fmt::format("Place = {}: the row has a place of its own, too; one of them is "
                        "to be removed",
                        quoted(named)));
      } else if (!found) {
        place_fault(fmt::format("Place: {}", found.why));
      } else {
        is_way_ = is_event_ && declarations_.events.at(from_->type).drives && places_.is_way(named);
        return std::move(*found.value);
      }
    } else if (geometry.kind.empty() && keeps_place()) {
      return geometry;
    } else if (geometry.kind.empty() && wants_geometry() && places_.has(placemark_.name)) {
      // A line on the map and a row of the same name are one event.
      Parsed<SourceGeometry> found = places_.geometry(placemark_.name);
      if (found) return std::move(*found.value);
      place_fault(found.why);
    } else if (geometry.kind.empty() && from_->columns->has_unknown_crs() && wants_geometry()) {
      ++place_faults_;
    } else if (geometry.kind.empty() && !placemark_.name.empty() && wants_geometry()) {
      const std::string hint = places_.hint(placemark_.name);
      if (hint.empty()) return geometry;
      place_fault(fmt::format("Name = {}: there is no place or line called so{}",
                              quoted(placemark_.name), hint),
                  column::name);
    }
    return geometry;
  }

  // A geometry that the row may have, in place of one with a reported fault: that it has none would
  // only follow from the fault.
  SourceGeometry stand_in() const {
    std::vector<GeometryKind> kinds{GeometryKind::point};
    if (is_event_) kinds = declarations_.events.at(from_->type).geometries;
    const auto takes = [&](GeometryKind kind) {
      return std::ranges::find(kinds, kind) != kinds.end();
    };
    if (takes(GeometryKind::point)) return {"Point", "0,0", 0};
    if (takes(GeometryKind::line)) return {"LineString", "0,0 0.001,0", 0};
    if (takes(GeometryKind::polygon)) return {"Polygon", "0,0 0.001,0 0,0.001 0,0", 0};
    return {};
  }

  // Whether the row is of a thing that was drawn, in a sheet that says of no row where it is.
  bool keeps_place() const {
    for (const char* name : {column::place, column::lon, column::lat, column::wkt}) {
      if (from_->columns->find(name) != nullptr) return false;
    }
    const ThingId id = thing_id(data_);
    return drawn_.contains(id);
  }

  bool wants_geometry() const {
    if (!is_event_) return from_->type != "MissionInfo";
    const auto& kinds = declarations_.events.at(from_->type).geometries;
    return std::ranges::find(kinds, GeometryKind::none) == kinds.end();
  }

  const Declarations& declarations_;
  const PlaceNames& places_;
  const std::set<ThingId>& drawn_;
  RowTimes times_;
  Notes& notes_;
  Faults& faults_;
  std::vector<std::string> rovers_, owners_;  // ids; owners: rovers and assets
  std::map<const Table*, Decimals> decimals_;
  std::map<const Table*, std::string> rover_above_;          // what rows below take over
  std::set<std::pair<const Table*, std::string>> reported_;  // columns of which a fault was told
  // The row that is being read, and what is known of it.
  const TypedRow* from_ = nullptr;
  SourcePlacemark placemark_;
  SourceData data_;
  bool is_event_ = false, is_way_ = false;
  int place_faults_ = 0;
  std::string rover_id_;
};

}  // namespace

RowPlacemarks placemarks_of(const std::vector<TypedRow>& rows, const Declarations& declarations,
                            const PlaceNames& places, SheetStart start,
                            const std::set<ThingId>& drawn, Notes& notes, Faults& faults) {
  PlacemarkMaker maker(rows, declarations, places, start, drawn, notes, faults);
  RowPlacemarks made;
  for (const TypedRow& row : rows) {
    made.placemarks.push_back(maker.placemark(row));
    if (maker.is_way()) made.ways.push_back(made.placemarks.size() - 1);
  }
  return made;
}

}  // namespace lsos
