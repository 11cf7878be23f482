#include "interchange/row_types.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "base/text.h"
#include "interchange/outline_item.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// Whether the row has a field that only things of a plan have.
bool looks_like_ours(const TableRow& row, const Columns& columns) {
  for (const char* field : {"RoverId", "Sequence", "RoverType", "AssetType", "Planet"}) {
    if (!columns.text(row, field).empty()) return true;
  }
  return false;
}

class RowTyper {
 public:
  RowTyper(const Table& table, const Columns& columns, const Declarations& declarations,
           const std::set<std::string>& wanted, PlaceNames& places, Faults& faults)
      : table_(table),
        columns_(columns),
        declarations_(declarations),
        wanted_(wanted),
        places_(places),
        faults_(faults),
        names_(plan_names(declarations)),
        table_type_(type_of_sheet(table, declarations)) {}

  void add(const TableRow& row) {
    const std::string text = columns_.text(row, column::type);
    if (name_meant(text, declarations_).empty() && is_place_word(text)) return add_place(row);
    if (text.empty() && row.geometry && is_wanted(row)) return add_place(row);
    std::string type = text.empty() ? table_type_ : name_meant(text, declarations_);
    if (!type.empty()) {
      typed_.push_back({&table_, &row, &columns_, std::move(type)});
      return;
    }
    const std::string name = columns_.text(row, column::name);
    // Layers of a map have columns Type of their own: "crater", "ridge".
    const bool is_ours = looks_like_ours(row, columns_);
    if (!text.empty() && (is_ours || table_.has_letters)) {
      if (broken_script(text)) return;
      const std::string hint = hint_for(text);
      faults_.error(place_of_cell(table_, row.number, columns_.find(column::type)->index),
                    fmt::format("Type = {}: there is no such event{}", quoted(text),
                                hint.empty() ? "; there are " + listed(names_.known()) : hint));
      return;
    }
    SourceGeometry geometry;
    Faults own;
    if (!is_ours) geometry = own_geometry(table_, row, columns_, own);
    faults_.add(own.sorted());
    // A second fault of the row would only follow.
    if (own.has_errors() || columns_.has_unknown_crs()) return;
    if (!name.empty() && !geometry.kind.empty()) {
      places_.add(name, {std::move(geometry), {table_.file, row.number}});
    } else if (table_.has_letters || is_ours) {
      untyped_.push_back(row.number);
    } else {
      nameless_ += 1;
    }
  }

  // Reports the rows that are nothing: each, or all where the sheet says of none what it is.
  // Returns whether it is all of them.
  bool report_untyped() {
    if (untyped_.empty()) return false;
    const bool is_all = untyped_.size() > 1 && untyped_.size() == table_.rows.size();
    if (is_all) {
      faults_.error({table_.file, 0},
                    fmt::format("none of its {} rows says what it is: a column Type is wanted, or "
                                "{} is to be called after them, Rovers, Assets, Mission, or an "
                                "event such as Route; rows with Name, Lon and Lat are places",
                                untyped_.size(), is_file() ? "the file" : "the sheet"));
      return true;
    }
    for (const int row : untyped_) {
      faults_.error({table_.file, row},
                    fmt::format("the row has neither a Type nor a name with a place; Type is one "
                                "of {}; a row of totals or remarks is to be removed, or to begin "
                                "with #",
                                listed(names_.known())));
    }
    return false;
  }

  std::vector<TypedRow> take(std::vector<std::string>& left_out) {
    if (nameless_ > 0) {
      left_out.push_back(fmt::format("{}: {} feature{} without a Type and a name", table_.file,
                                     nameless_, nameless_ == 1 ? "" : "s"));
    }
    return std::move(typed_);
  }

 private:
  bool is_file() const {
    return table_.file.find('/', table_.file.rfind('.')) == std::string::npos;
  }

  // "; did you mean 'Route'?": by the words of outlines, else by letters.
  std::string hint_for(const std::string& text) {
    const std::vector<std::string> said = events_said(text, declarations_);
    if (said.empty()) return names_(text);
    std::vector<std::string> names;
    for (const std::string& event : said) names.push_back(quoted(event));
    return fmt::format("; did you mean {}?", fmt::join(names, " or "));
  }

  static bool is_place_word(const std::string& text) {
    return lower_case(text) == "place" || lower_case(text) == "places";
  }

  // Whether a row of a sheet names the feature, which says nothing of an event itself.
  bool is_wanted(const TableRow& row) const {
    return !looks_like_ours(row, columns_) &&
           wanted_.contains(lower_case(columns_.text(row, column::name)));
  }

  void add_place(const TableRow& row) {
    const std::string name = columns_.text(row, column::name);
    Faults own;
    SourceGeometry geometry = own_geometry(table_, row, columns_, own);
    faults_.add(own.sorted());
    if (own.has_errors()) return;
    if (!name.empty() && !geometry.kind.empty()) {
      places_.add(name, {std::move(geometry), {table_.file, row.number}});
      return;
    }
    faults_.error({table_.file, row.number},
                  fmt::format("a Place has {}; Name and Lon and Lat are wanted",
                              name.empty() ? "no name" : "no coordinates"));
  }

  bool broken_script(const std::string& name) {
    const auto broken = declarations_.broken_events.find(name);
    if (broken == declarations_.broken_events.end()) return false;
    faults_.add(broken->second);
    return true;
  }

  const Table& table_;
  const Columns& columns_;
  const Declarations& declarations_;
  const std::set<std::string>& wanted_;
  PlaceNames& places_;
  Faults& faults_;
  Suggestions names_;
  std::string table_type_;
  std::vector<TypedRow> typed_;
  int nameless_ = 0;
  std::vector<int> untyped_;  // numbers of rows that are nothing
};

}  // namespace

Place TypedRow::cell_place(const std::string& column) const {
  const SheetColumn* found = columns->find(column);
  if (found == nullptr) return {table->file, row->number};
  return place_of_cell(*table, row->number, found->index);
}

std::set<std::string> wanted_places(const Table& table, const Columns& columns) {
  std::set<std::string> names;
  for (const TableRow& row : table.rows) {
    if (row.geometry) continue;
    names.insert(lower_case(columns.text(row, column::name)));
    const std::string places = columns.text(row, column::place);
    for (std::size_t from = 0; from < places.size();) {
      const std::size_t end = std::min(places.find(';', from), places.size());
      names.insert(
          lower_case(std::string(trimmed(std::string_view(places).substr(from, end - from)))));
      from = end + 1;
    }
  }
  names.erase("");
  return names;
}

TypedRows typed_rows(const Table& table, const Columns& columns, const Declarations& declarations,
                     const std::set<std::string>& wanted, PlaceNames& places,
                     std::vector<std::string>& left_out, Faults& faults) {
  RowTyper typer(table, columns, declarations, wanted, places, faults);
  for (const TableRow& row : table.rows) typer.add(row);
  const bool are_none = typer.report_untyped();
  return {typer.take(left_out), are_none};
}

}  // namespace lsos
