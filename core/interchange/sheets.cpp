#include "interchange/sheets.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "access/file_access.h"
#include "access/gdal_access.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/text.h"
#include "base/units.h"
#include "interchange/cell_text.h"
#include "interchange/clock_text.h"
#include "interchange/workbook_archive.h"
#include "plan/kml_text.h"
#include "planet/utc.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

// Options of GDAL's drivers for as long as it lives, on this thread.
class SheetOptions {
 public:
  SheetOptions() { set("DISABLE", "STRING"); }
  ~SheetOptions() { set(nullptr, nullptr); }
  SheetOptions(const SheetOptions&) = delete;
  SheetOptions& operator=(const SheetOptions&) = delete;

 private:
  static void set(const char* headers, const char* types) {
    for (const char* key : {"OGR_XLSX_HEADERS", "OGR_ODS_HEADERS"}) {
      CPLSetThreadLocalConfigOption(key, headers);
    }
    for (const char* key : {"OGR_XLSX_FIELD_TYPES", "OGR_ODS_FIELD_TYPES"}) {
      CPLSetThreadLocalConfigOption(key, types);
    }
  }
};

using Cells = std::vector<std::vector<std::string>>;

bool is_empty(const std::vector<std::string>& cells) {
  return std::ranges::all_of(cells, [](const std::string& text) { return trimmed(text).empty(); });
}

// Adds the rows as a table that begins with the first row with text.
void add_table(Cells rows, const std::string& file, const std::string& name,
               std::vector<Table>& tables) {
  Table table;
  table.file = file;
  table.name = name;
  table.has_letters = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_empty(rows[i])) continue;
    const int number = static_cast<int>(i) + 1;
    if (table.header.empty()) {
      table.header = std::move(rows[i]);
      table.header_number = number;
    } else {
      table.rows.push_back({number, std::move(rows[i])});
    }
  }
  if (!table.header.empty()) tables.push_back(std::move(table));
}

// Shortest digits of a number that GDAL prints as "5.5000000000000000", or a workbook has as
// "80.11781499999999".
std::string plain_number(const std::string& text) {
  constexpr std::size_t digits_many = 16;  // with a point; people write fewer
  const std::size_t point = text.find('.');
  if (point == std::string::npos || text.size() < digits_many) return text;
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return text;
  return fmt::format("{}", value);
}

// A date that was counted from 1900 though the file counts from 1904.
std::string shifted_date(const std::string& text) {
  constexpr int days_between = 1462;
  const bool is_date = text.size() >= 10 && text[4] == '/' && text[7] == '/';
  if (!is_date) return text;
  const Parsed<std::string> utc = utc_text(text, {});
  const Parsed<Instant> instant = parse_utc(utc ? *utc.value : "");
  if (!instant) return text;
  const Parsed<std::string> date = date_of_day(fmt::format("{}", days_between + 1), *instant.value);
  return date ? *date.value + text.substr(10) : text;
}

std::optional<double> cell_number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

// A number as its cell shows it: "26:00:00" of 1.0833 days, "5 km/h".
std::string as_shown(const std::string& text, const ShownFormat& format) {
  const std::optional<double> number = cell_number(text);
  if (!number) return text;
  if (format.is_span && *number >= 0 && *number < 10000) {
    const auto whole_s = static_cast<long long>(std::llround(*number * 86400));
    return fmt::format("{}:{:02}:{:02}", whole_s / 3600, whole_s / 60 % 60, whole_s % 60);
  }
  // Nearly all decimals of 15 digits survive as a number; a product has noise beyond.
  if (format.unit == "%") return fmt::format("{:.15g} %", *number * 100);
  return find_unit(format.unit) == nullptr ? text : fmt::format("{} {}", text, format.unit);
}

// "08:00:00" of a clock in an ODS cell, "PT08H00M00S".
std::string ods_clock(const std::string& text) {
  int hours = 0, minutes = 0, seconds = 0, length = 0;
  const int count = std::sscanf(text.c_str(), "PT%dH%dM%dS%n", &hours, &minutes, &seconds, &length);
  if (count != 3 || static_cast<std::size_t>(length) != text.size()) return text;
  return fmt::format("{:02}:{:02}:{:02}", hours, minutes, seconds);
}

void fill_merged(const std::vector<MergedCells>& merged, Cells& rows) {
  for (const MergedCells& block : merged) {
    if (block.row >= rows.size() || block.column >= rows[block.row].size()) continue;
    const std::string text = rows[block.row][block.column];
    const std::size_t end = std::min(block.row + block.rows, rows.size());
    for (std::size_t row = block.row; row < end; ++row) {
      const std::size_t columns = std::min(block.column + block.columns, rows[row].size());
      for (std::size_t i = block.column; i < columns; ++i) rows[row][i] = text;
    }
  }
}

Cells cells_of(OGRLayer& layer, const WorkbookFacts& facts, const std::string& file,
               std::size_t& cells_left) {
  Cells rows;
  layer.ResetReading();
  while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
    const auto columns = static_cast<std::size_t>(feature->GetFieldCount());
    if (columns > cells_left) {
      throw InputError({file, 0}, fmt::format("has more than {} cells", cells_max));
    }
    cells_left -= columns;
    const auto number = static_cast<std::size_t>(std::max<GIntBig>(feature->GetFID(), 1));
    rows.resize(std::max(rows.size(), number));
    for (int i = 0; i < feature->GetFieldCount(); ++i) {
      std::string text =
          feature->IsFieldSetAndNotNull(i) != 0 ? feature->GetFieldAsString(i) : std::string();
      text = plain_number(text);
      if (facts.is_ods) text = unguarded_in_ods(ods_clock(text));
      if (facts.counts_from_1904) text = shifted_date(text);
      rows[number - 1].push_back(std::move(text));
    }
  }
  return rows;
}

// The text with titles above its header as comments: lines without a separator before the first
// that has several, which tells the separator.
std::string without_titles(const std::string& text) {
  constexpr int lines_tried = 10;
  const bool has_mark = text.starts_with("\xef\xbb\xbf");
  std::size_t from = has_mark ? 3 : 0;
  std::string marked = text.substr(0, from);
  for (int i = 0; i < lines_tried && from < text.size(); ++i) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, end - from);
    const bool has_separator = line.find_first_of(";,\t") != std::string::npos;
    if (line.find('"') != std::string::npos) return text;
    if (has_separator) return marked + text.substr(from);
    const bool is_blank = trimmed(line).empty();
    marked += (is_blank ? "" : "# ") + line + '\n';
    from = end + 1;
  }
  return text;
}

bool is_utf8(const std::string& bytes) {
  return CPLIsUTF8(bytes.c_str(), static_cast<int>(bytes.size())) != 0;
}

}  // namespace

std::string csv_text(const std::string& bytes, const std::string& file) {
  using namespace std::string_view_literals;
  const std::string_view text = bytes;
  const bool is_wide = text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv);
  if (is_wide) return to_utf8(bytes, file);
  if (bytes.find('\0') != std::string::npos) {
    throw InputError({file, 0}, "holds a zero byte, so it is no text; save the sheet as CSV UTF-8");
  }
  if (is_utf8(bytes)) return bytes;
  const std::unique_ptr<char, decltype(&VSIFree)> recoded(
      CPLRecode(bytes.c_str(), "CP1252", CPL_ENC_UTF8), &VSIFree);
  return recoded.get();
}

std::vector<Table> read_csv(const std::string& bytes, const std::string& file) {
  const CsvTable csv = parse_csv(without_titles(csv_text(bytes, file)));
  if (!csv.fault.empty()) throw InputError({file, csv.fault_line}, csv.fault);
  Table table;
  table.file = file;
  table.name = std::filesystem::path(file).stem().string();
  table.has_letters = true;
  table.has_commas = csv.separator == ';' || csv.separator == '\t';
  std::size_t cells_left = cells_max;
  for (CsvRow row : csv.rows) {
    for (std::string& cell : row.cells) cell = unguarded_text(cell);
    if (row.cells.size() > cells_left) {
      throw InputError({file, row.line}, fmt::format("has more than {} cells", cells_max));
    }
    cells_left -= row.cells.size();
    if (is_empty(row.cells)) continue;
    if (table.header.empty()) {
      table.header = row.cells;
      table.header_number = row.line;
    } else {
      table.rows.push_back({row.line, row.cells});
    }
  }
  if (table.header.empty()) throw InputError({file, 0}, "has no cell with text in it");
  return {std::move(table)};
}

std::vector<Table> read_workbook(const std::string& bytes, const std::string& file) {
  const WorkbookFacts facts = workbook_facts(bytes, file, sheet_bytes_max);
  const GdalSilence silence;
  const SheetOptions options;
  register_drivers();
  allow_file(file);
  const char* const drivers[] = {facts.is_ods ? "ODS" : "XLSX", nullptr};
  const Dataset dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers));
  if (dataset == nullptr) {
    throw InputError({file, 0},
                     fmt::format("cannot be read as a spreadsheet: {}", GdalSilence::message()));
  }
  std::vector<Table> tables;
  std::size_t cells_left = cells_max;
  for (int i = 0; i < dataset->GetLayerCount(); ++i) {
    OGRLayer& layer = *dataset->GetLayer(i);
    const std::string name = layer.GetName();
    Cells rows = cells_of(layer, facts, file, cells_left);
    if (const auto texts = facts.texts.find(name); texts != facts.texts.end()) {
      for (const auto& [at, text] : texts->second) {
        if (at.first >= rows.size() || at.second >= rows[at.first].size()) continue;
        rows[at.first][at.second] = text;
      }
    }
    if (const auto formats = facts.formats.find(name); formats != facts.formats.end()) {
      for (const auto& [at, format] : formats->second) {
        if (at.first >= rows.size() || at.second >= rows[at.first].size()) continue;
        std::string& text = rows[at.first][at.second];
        text = as_shown(text, format);
      }
    }
    if (const auto merged = facts.merged.find(name); merged != facts.merged.end()) {
      fill_merged(merged->second, rows);
    }
    add_table(std::move(rows), fmt::format("{}/{}", file, name), name, tables);
  }
  if (tables.empty()) throw InputError({file, 0}, "has no cell with text in it");
  return tables;
}

}  // namespace lsos
