#include "interchange/source_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "base/error.h"
#include "base/replaced.h"
#include "base/sha256.h"
#include "base/visible_text.h"
#include "interchange/columns.h"
#include "interchange/map_tables.h"
#include "interchange/outline.h"
#include "interchange/sheets.h"
#include "interchange/xpjson.h"
#include "plan/kml_reader.h"
#include "plan/kml_text.h"
#include "plan/kmz_archive.h"
#include "plan/layer_reader.h"

namespace lsos {

namespace {

std::string ending_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

// Formats whose coordinates are degrees of WGS84 by definition, which people take for degrees of
// the body that they draw on.
std::vector<Table> without_body(std::vector<Table> tables) {
  for (Table& table : tables) {
    if (table.is_geographic && table.body == "Earth") table.body.clear();
  }
  return tables;
}

// GDAL would fetch a CRS that is a link. The member stands near the beginning, or at the end.
void refuse_linked_crs(const std::string& bytes, const std::string& file) {
  constexpr std::size_t reach = 300;  // characters that such a member takes, with some room
  for (std::size_t at = bytes.find("\"crs\""); at != std::string::npos;
       at = bytes.find("\"crs\"", at + 1)) {
    if (bytes.substr(at, reach).find("\"link\"") == std::string::npos) continue;
    throw InputError(
        {file, 1 + static_cast<int>(std::count(
                       bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(at), '\n'))},
        "its crs is a link, and no link is followed; a name such as "
        "urn:ogc:def:crs:OGC:1.3:CRS84 is wanted");
  }
}

// The layers of a GPX file are called routes, which are not events for that.
std::vector<Table> without_names(std::vector<Table> tables) {
  for (Table& table : tables) table.name.clear();
  return tables;
}

// The text as it comes back from a plan, which is XML: without control characters, each line ended
// by a line feed.
std::string text_in_xml(const std::string& text) {
  return replaced(replaced(xml_text(text), "\r\n", "\n"), "\r", "\n");
}

std::vector<Table> json_tables(const std::string& bytes, const std::string& file,
                               const Declarations& declarations,
                               std::vector<std::string>& left_out) {
  if (!is_xpjson(bytes)) {
    refuse_linked_crs(bytes, file);
    return without_body(tables_of(read_layers(file, "GeoJSON")));
  }
  std::vector<std::string> events;
  for (const auto& [name, event] : declarations.events) events.push_back(name);
  return read_xpjson(bytes, file, events, left_out);
}

std::vector<Table> tables_in(const std::string& file, const Declarations& declarations,
                             std::vector<std::string>& left_out) {
  const std::string ending = ending_of(file);
  const bool is_workbook = ending == ".xlsx" || ending == ".ods";
  const bool is_csv = ending == ".csv" || ending == ".tsv";
  if (ending == ".xls") {
    throw InputError({file, 0}, "is a workbook of an old format; save it as .xlsx, .ods or .csv");
  }
  const std::string bytes = read_bytes(file);
  if (bytes.empty()) throw InputError({file, 0}, "is empty");
  if (is_csv && is_zip(bytes)) {
    throw InputError({file, 0},
                     "is a workbook, though its name ends as that of a CSV file; rename "
                     "it to .xlsx or .ods");
  }
  if (is_workbook && !is_zip(bytes)) {
    throw InputError({file, 0}, fmt::format("is no {} file; a spreadsheet program saves one, or a "
                                            ".csv",
                                            ending));
  }
  if (is_csv) return read_csv(bytes, file);
  if (is_workbook) return read_workbook(bytes, file);
  if (ending == ".json" || ending == ".geojson" || ending == ".xpjson") {
    return json_tables(bytes, file, declarations, left_out);
  }
  if (ending == ".shp") return tables_of(read_layers(file, "ESRI Shapefile"));
  if (ending == ".gpx") return without_names(without_body(tables_of(read_layers(file, "GPX"))));
  if (ending == ".gpkg" || is_geopackage(bytes)) return tables_of(read_layers(file));
  if (ending == ".kml" || ending == ".kmz") return tables_of(parse_kml(bytes, file));
  if (ending == ".txt" || ending == ".md") return read_outline(bytes, file, declarations);
  throw InputError(
      {file, 0}, fmt::format("{} is no format that is imported; there are {}",
                             ending.empty() ? "a name without an ending" : ending, import_formats));
}

}  // namespace

std::vector<Table> read_tables(const std::string& file, const Declarations& declarations,
                               std::vector<std::string>& left_out) {
  std::vector<Table> tables = tables_in(file, declarations, left_out);
  for (Table& table : tables) {
    for (std::string& name : table.header) name = text_in_xml(name);
    for (TableRow& row : table.rows) {
      for (std::string& text : row.cells) text = text_in_xml(text);
    }
  }
  return tables;
}

void report_equal_files(const std::vector<std::string>& files, Faults& faults) {
  std::map<std::string, std::string> known;  // files by their bytes' hash
  for (const std::string& file : files) {
    std::string hash;
    try {
      hash = sha256_hex(read_bytes(file));
      // A Shapefile's features differ by the files beside it, too.
      if (ending_of(file) == ".shp") hash += std::filesystem::absolute(file).string();
    } catch (const InputError&) {
      continue;
    }
    const auto [first, is_new] = known.emplace(hash, file);
    if (is_new) continue;
    const std::string what =
        first->second == file ? "is given twice" : "has the same content as " + first->second;
    faults.error({file, 0}, what +
                                ", so that all in it would stand twice in the plan; it is to "
                                "be given once");
  }
}

}  // namespace lsos
