#include "interchange/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/text.h"
#include "base/units.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

// The letters and digits of a text, in lower case: "Rover ID" and "rover_id" are the same.
std::string bare(std::string_view text) {
  std::string letters;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0) letters += static_cast<char>(std::tolower(byte));
  }
  return letters;
}

// Everyday words for columns, as bare() makes them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 39> everyday{
    {{"event", column::type},
     {"task", column::type},
     {"activity", column::type},
     {"kind", column::type},
     {"what", column::type},
     {"label", column::name},
     {"title", column::name},
     {"names", column::name},
     {"notes", column::description},
     {"note", column::description},
     {"comment", column::description},
     {"comments", column::description},
     {"remarks", column::description},
     {"desc", column::description},
     {"date", column::day},
     {"days", column::day},
     {"location", column::place},
     {"where", column::place},
     {"site", column::place},
     {"places", column::place},
     {"waypoints", column::place},
     {"via", column::place},
     {"longitude", column::lon},
     {"long", column::lon},
     {"lng", column::lon},
     {"londeg", column::lon},
     {"latitude", column::lat},
     {"latdeg", column::lat},
     {"geometry", column::wkt},
     {"geom", column::wkt},
     {"rover", "RoverId"},
     {"vehicle", "RoverId"},
     {"seq", "Sequence"},
     {"no", "Sequence"},
     {"nr", "Sequence"},
     {"start", "StartTime"},
     {"time", "StartTime"},
     {"starts", "StartTime"},
     {"begin", "StartTime"}}};

constexpr std::array special{column::type,  column::name, column::description, column::day,
                             column::place, column::lon,  column::lat,         column::wkt};

// Canonical names by their bare letters.
std::map<std::string, std::string> known_columns(const Declarations& declarations) {
  std::map<std::string, std::string> known;
  for (const auto& [word, name] : everyday) known.emplace(word, name);
  // Names of fields come before everyday words: an event may have a field Kind.
  const auto add = [&](const std::string& name) { known.insert_or_assign(bare(name), name); };
  for (const std::string& name : plan_names(declarations)) {
    for (const auto& list : fields_of(name, declarations)) {
      for (const FieldDeclaration& field : list) add(field.name);
    }
  }
  for (const char* name : special) add(name);
  return known;
}

// Splits "Duration in min" and "Speed km/h", whose last word is a unit.
std::pair<std::string, std::string> name_and_last_unit(const std::string& header) {
  const std::size_t blank = header.find_last_of(' ');
  if (blank == std::string::npos) return {header, ""};
  const std::string unit = header.substr(blank + 1);
  std::string name(trimmed(header.substr(0, blank)));
  const bool has_in = name.ends_with(" in");
  if (has_in) name = trimmed(name.substr(0, name.size() - 3));
  return find_unit(unit) != nullptr || has_in ? std::pair(name, unit)
                                              : std::pair(header, std::string());
}

// Splits "Speed (km/h)", "Speed [km/h]" or "Speed in km/h" into its name and its unit.
std::pair<std::string, std::string> name_and_unit(const std::string& header) {
  const std::size_t open = header.find_last_of("([");
  if (open == std::string::npos || open == 0) return name_and_last_unit(header);
  const char close = header[open] == '(' ? ')' : ']';
  if (header.back() != close) return {header, ""};
  return {std::string(trimmed(header.substr(0, open))),
          std::string(trimmed(header.substr(open + 1, header.size() - open - 2)))};
}

bool is_filled(const Table& table, std::size_t index) {
  return std::ranges::any_of(table.rows,
                             [&](const TableRow& row) { return !cell(row, index).empty(); });
}

// Columns that map tools add to every feature.
bool is_tool_column(const std::string& letters) {
  constexpr std::array<std::string_view, 12> stamped{
      "fid",        "id",      "timestamp",  "end",       "altitude", "altitudemode",
      "tessellate", "extrude", "visibility", "draworder", "icon",     "snippet"};
  return std::ranges::find(stamped, letters) != stamped.end();
}

// Whether a column of a sheet is a coordinate in metres, and no other says where things are.
bool is_projected(const Table& table, const std::string& header,
                  const std::map<std::string, std::string>& known) {
  constexpr std::array<std::string_view, 4> words{"x", "y", "easting", "northing"};
  const bool is_one = std::ranges::find(words, bare(name_and_unit(header).first)) != words.end();
  if (!is_one || !table.has_letters) return false;
  return std::ranges::none_of(table.header, [&](const std::string& each) {
    const auto found = known.find(bare(each));
    if (found == known.end()) return false;
    return found->second == column::lon || found->second == column::lat ||
           found->second == column::wkt || found->second == column::place;
  });
}

// Whether things of a plan may be among the rows: always in a sheet; of a map where the layer or a
// column says so.
bool may_have_things(const Table& table, const Declarations& declarations) {
  if (table.has_letters || !type_of_sheet(table, declarations).empty()) return true;
  return std::ranges::any_of(table.header, [](const std::string& header) {
    return header == column::type || header == "RoverId" || header == "Sequence";
  });
}

// Reports the first cell of a sheet with text to the right of all headers: a comma too many has
// moved what stands there.
void report_cells_beside(const Table& table, Faults& faults) {
  if (!table.has_letters) return;
  for (const TableRow& row : table.rows) {
    for (std::size_t i = table.header.size(); i < row.cells.size(); ++i) {
      const std::string text = cell(row, i);
      if (text.empty()) continue;
      faults.error(place_of_cell(table, row.number, i),
                   fmt::format("{} stands beside the last header; a text with a separator in it is "
                               "to be in double quotes",
                               quoted(text)));
      return;
    }
  }
}

}  // namespace

std::vector<std::string> plan_names(const Declarations& declarations) {
  std::vector<std::string> names{"MissionInfo", "Rover", "Asset"};
  for (const auto& [name, event] : declarations.events) names.push_back(name);
  return names;
}

std::string column_meant(const std::string& header, const Declarations& declarations) {
  const std::map<std::string, std::string> known = known_columns(declarations);
  const auto found = known.find(bare(header));
  return found == known.end() ? "" : found->second;
}

std::size_t known_headers(const std::vector<std::string>& cells, const Declarations& declarations) {
  const std::map<std::string, std::string> known = known_columns(declarations);
  std::size_t count = 0;
  for (const std::string& text : cells) {
    const std::string header(trimmed(text));
    if (known.contains(bare(name_and_unit(header).first)) || known.contains(bare(header))) ++count;
  }
  return count;
}

std::string name_meant(const std::string& text, const Declarations& declarations) {
  const std::string letters = bare(text);
  if (letters.empty()) return "";
  if (letters == "mission") return "MissionInfo";
  for (const std::string& name : plan_names(declarations)) {
    const std::string known = bare(name);
    if (letters == known || letters == known + "s") return name;
  }
  return "";
}

std::string type_of_sheet(const Table& table, const Declarations& declarations) {
  std::string type = name_meant(table.name, declarations);
  const std::size_t mark = table.name.find_last_of("-_ ");
  const bool has_words = table.has_letters && mark != std::string::npos;
  return type.empty() && has_words ? name_meant(table.name.substr(mark + 1), declarations) : type;
}

Columns::Columns(const Table& table, const Declarations& declarations, Faults& faults) {
  const std::map<std::string, std::string> known = known_columns(declarations);
  std::vector<std::string> names;
  for (const auto& [letters, name] : known) {
    if (bare(name) == letters) names.push_back(name);
  }
  Suggestions suggest(names);
  report_cells_beside(table, faults);
  std::map<std::string, Place> first;
  const bool tells_unused = may_have_things(table, declarations);
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    const std::string header(trimmed(table.header[i]));
    const Place place = place_of_cell(table, table.header_number, i);
    if (header.empty()) {
      if (!is_filled(table, i)) continue;
      faults.warning(place, "a column without a header is not used");
      continue;
    }
    const auto [word, unit] = name_and_unit(header);
    // Brackets hold a unit, or belong to the name.
    auto found = known.find(bare(word));
    const bool has_unit = found != known.end();
    if (!has_unit) found = known.find(bare(header));
    if (found == known.end() && is_projected(table, header, known)) {
      if (!has_unknown_crs_) {
        faults.error(
            place,
            "X and Y have no CRS that is known: degrees under Lon and Lat are wanted, or a "
            "map with its CRS (.gpkg, .shp)");
      }
      has_unknown_crs_ = true;
      continue;
    }
    if (found == known.end()) {
      if (is_tool_column(bare(header)) || !is_filled(table, i)) continue;
      // A slip of one letter in a sheet is an error, and the column is read as it was meant; sheets
      // and maps have columns of their own.
      const std::string hint = table.has_letters ? suggest(word) : "";
      const std::string meant = hint.empty() ? "" : bare(hint.substr(hint.find('\'')));
      const std::string what =
          fmt::format("the column {} is not used: no field is called so{}", quoted(header), hint);
      found = known.find(meant);
      if (found == known.end() || edit_distance(meant, bare(word)) > 1) {
        if (tells_unused) faults.warning(place, what);
        continue;
      }
      faults.error(place, what);
    }
    const auto earlier = first.find(found->second);
    if (earlier != first.end() && !table.has_letters) {
      // Maps have columns of their own, "label" beside "name": the very name of the field counts.
      if (header == found->second) columns_[found->second] = SheetColumn{i, ""};
      continue;
    }
    if (earlier != first.end()) {
      faults.error(place,
                   fmt::format("the column {} stands twice, here and at {}{}; one of them is "
                               "to be renamed or removed",
                               found->second, earlier->second.column, earlier->second.line));
      continue;
    }
    first.emplace(found->second, place);
    columns_.emplace(found->second, SheetColumn{i, has_unit ? unit : ""});
  }
}

const SheetColumn* Columns::find(const std::string& name) const {
  const auto found = columns_.find(name);
  return found == columns_.end() ? nullptr : &found->second;
}

std::string Columns::text(const TableRow& row, const std::string& name) const {
  const SheetColumn* found = find(name);
  return found == nullptr ? "" : cell(row, found->index);
}

}  // namespace lsos
