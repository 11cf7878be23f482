#include "interchange/row_placemarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/replaced.h"
#include "interchange/cell_text.h"
#include "interchange/clock_text.h"
#include "interchange/decimals.h"
#include "interchange/names_in_any_case.h"
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
                 const PlaceNames& places, std::optional<Instant> start, Notes& notes,
                 Faults& faults)
      : declarations_(declarations),
        places_(places),
        start_(start),
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
    if (is_event_) begin_event();
    add_fields();
    if (is_event_) end_event();
    sort_fields();
    add_geometry();
    placemark_.data.push_back(std::move(data_));
    return std::move(placemark_);
  }

 private:
  // What rows below take over from those above, in one table.
  struct Above {
    std::string rover_id;
    std::string date;  // of the Day: "2026-07-03"
  };
  // What rows of one rover take over from the row before.
  struct Before {
    std::optional<Instant> start;
    std::string date;
  };

  std::string text(const std::string& column) const {
    return from_->columns->text(*from_->row, column);
  }
  Place cell_place(const std::string& column) const {
    const Column* found = from_->columns->find(column);
    if (found == nullptr) return {from_->table->file, from_->row->number};
    return place_of_cell(*from_->table, from_->row->number, found->index);
  }
  void add_field(const std::string& name, std::string value) {
    const Place place = cell_place(name);
    data_.fields.push_back({name, std::move(value), place.line, place.column});
  }

  void begin_event() {
    Above& above = above_[from_->table];
    if (const std::string id = text("RoverId"); !id.empty()) above.rover_id = meant(id, rovers_);
    rover_id_ = above.rover_id;
    if (const std::string day = text(column::day); !day.empty()) set_date(day, above);
    date_ = above.date;
    if (date_.empty() && start_) date_ = *date_of_day("1", *start_).value;
    before_ = &before_of_[rover_id_];
    has_day_ = !above.date.empty();
  }

  void set_date(const std::string& day, Above& above) {
    if (!start_) {
      faults_.error(cell_place(column::day),
                    fmt::format("Day = {}: days are counted from the StartTime of MissionInfo, "
                                "which is missing or cannot be read",
                                quoted(day)));
      return;
    }
    const Parsed<std::string> date = date_of_day(day, *start_);
    if (date) {
      above.date = *date.value;
    } else {
      faults_.error(cell_place(column::day), fmt::format("Day = {}", date.why));
    }
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
                 const Column& column) {
    const bool is_number = field.kind == FieldKind::number || field.kind == FieldKind::duration ||
                           field.kind == FieldKind::moment;
    Parsed<std::string> number{cell_text, {}};
    if (is_number && from_->table->has_commas) number = with_decimal_point(cell_text, decimals());
    if (!number) {
      faults_.error(cell_place(field.name), fmt::format("{} = {}", field.name, number.why));
      return add_field(field.name, replaced(cell_text, ",", "."));  // read on as a decimal
    }
    if (is_number && column.unit.empty()) note_unit(field, *number.value, column);
    add_field(field.name, field_text(*number.value, field, column.unit, from_->table->has_commas));
  }

  // Tells once for a column of a sheet what its numbers without a unit are.
  void note_unit(const FieldDeclaration& field, const std::string& text, const Column& column) {
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
      const std::string cell_text = text(name);
      if (is_special(name) || cell_text.empty()) continue;
      const FieldDeclaration* field = declared_field(from_->type, name, declarations_);
      if (field == nullptr) {  // reported with the names that there are when the plan is read
        add_field(name, cell_text);
        continue;
      }
      if (const std::string why = unit_fault(column.unit, *field); !why.empty()) {
        if (reported_.emplace(from_->table, name).second) {
          faults_.error(place_of_cell(*from_->table, from_->table->header_number, column.index),
                        why);
        }
        continue;
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

  void add_time(const FieldDeclaration& field, const std::string& cell_text, const Column& column) {
    const TimeContext context =
        is_event_ ? TimeContext{date_, start_to_count_from()} : TimeContext{"", {}};
    // A moment may be a duration from the start, which begins with a digit and has no colon.
    const bool may_be_duration = field.kind == FieldKind::moment &&
                                 cell_text.find(':') == std::string::npos &&
                                 cell_text.find('-') == std::string::npos;
    if (may_be_duration && !cell_text.starts_with('+')) {
      return add_value(field, cell_text, column);
    }
    Parsed<std::string> time = utc_text(cell_text, context);
    const bool takes_first_day = time && is_event_ && !has_day_ && clock_s(cell_text);
    if (takes_first_day && reported_.emplace(from_->table, column::day).second) {
      faults_.warning(
          cell_place(field.name),
          fmt::format("{} = {}: no Day is said, so clock times of this sheet are of day "
                      "1, {}",
                      field.name, cell_text, date_));
    }
    if (time && is_event_ && has_day_) note_other_days(cell_text);
    if (time && !parse_utc(*time.value)) {
      time.why = fmt::format(
          "{} is no time; 08:00, '+2 h', and a date and time such as 2026-07-01 "
          "08:00 are allowed",
          quoted(cell_text));
    }
    if (time.why.empty()) return add_field(field.name, std::move(*time.value));
    faults_.error(cell_place(field.name), fmt::format("{} = {}", field.name, time.why));
  }

  // Tells where a clock time falls on another day of reports, `check` and `edit`.
  void note_other_days(const std::string& cell_text) {
    const std::string start_clock = format_utc(*start_).substr(11, 5);
    const auto clock = clock_s(cell_text), days_begin = clock_s(start_clock);
    if (!clock || !days_begin || *clock >= *days_begin) return;
    notes_.add(
        fmt::format("days are UTC dates here; reports, check and edit count them from {0} "
                    "on, when the mission starts, so that a time before {0} is of the day "
                    "before there",
                    start_clock));
  }

  // The row's own start, which is read before other times, else the last above.
  std::optional<Instant> start_to_count_from() const {
    const SourceField* own = find("StartTime");
    const Parsed<Instant> start = own == nullptr ? Parsed<Instant>{} : parse_utc(own->text);
    return start ? start.value : before_->start;
  }

  const SourceField* find(const std::string& name) const {
    const auto found = std::ranges::find(data_.fields, name, &SourceField::name);
    return found == data_.fields.end() ? nullptr : &*found;
  }

  void end_event() {
    if (find("RoverId") == nullptr && !rover_id_.empty()) add_field("RoverId", rover_id_);
    if (find("Sequence") == nullptr) add_field("Sequence", "");  // see number_events()
    begin_day();
    const SourceField* start = find("StartTime");
    const Parsed<Instant> instant = start == nullptr ? Parsed<Instant>{} : parse_utc(start->text);
    if (instant && before_->start && *instant.value < *before_->start) {
      faults_.warning(
          cell_place("StartTime"),
          fmt::format("{} is before the start that a row above of rover {} has, {}; is a "
                      "Day wanted?",
                      start->text, quoted(rover_id_), format_utc(*before_->start)));
    }
    if (instant) before_->start = instant.value;
    if (has_day_) before_->date = date_;
    set_folders();
  }

  // The first row of a rover on a new day that says no time does not begin before that day.
  void begin_day() {
    if (!has_day_ || date_ == before_->date || find("StartTime") != nullptr || !start_) return;
    const Parsed<Instant> midnight = parse_utc(date_ + "T00:00:00Z");
    if (midnight && *midnight.value > *start_) add_field("StartTime", date_ + "T00:00:00Z");
  }

  void set_folders() {
    if (!rover_id_.empty()) placemark_.folders.push_back(rover_id_);
    if (has_day_) placemark_.folders.push_back(date_);
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

  bool wants_geometry() const {
    if (!is_event_) return from_->type != "MissionInfo";
    const auto& kinds = declarations_.events.at(from_->type).geometries;
    return std::ranges::find(kinds, GeometryKind::none) == kinds.end();
  }

  const Declarations& declarations_;
  const PlaceNames& places_;
  std::optional<Instant> start_;
  Notes& notes_;
  Faults& faults_;
  std::vector<std::string> rovers_, owners_;  // ids; owners: rovers and assets
  std::map<const Table*, Decimals> decimals_;
  std::map<const Table*, Above> above_;
  std::map<std::string, Before> before_of_;
  std::set<std::pair<const Table*, std::string>> reported_;  // columns of which a fault was told
  // The row that is being read, and what is known of it.
  const TypedRow* from_ = nullptr;
  SourcePlacemark placemark_;
  SourceData data_;
  bool is_event_ = false, has_day_ = false, is_way_ = false;
  int place_faults_ = 0;
  std::string rover_id_, date_;
  Before* before_ = nullptr;
};

}  // namespace

RowPlacemarks placemarks_of(const std::vector<TypedRow>& rows, const Declarations& declarations,
                            const PlaceNames& places, std::optional<Instant> start, Notes& notes,
                            Faults& faults) {
  PlacemarkMaker maker(rows, declarations, places, start, notes, faults);
  RowPlacemarks made;
  for (const TypedRow& row : rows) {
    made.placemarks.push_back(maker.placemark(row));
    if (maker.is_way()) made.ways.push_back(made.placemarks.size() - 1);
  }
  return made;
}

}  // namespace lsos
