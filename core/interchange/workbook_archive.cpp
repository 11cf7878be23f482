#include "interchange/workbook_archive.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <string_view>

#include "base/error.h"
#include "base/text.h"
#include "interchange/ods_facts.h"
#include "plan/xml_element.h"
#include "plan/zip_handle.h"

namespace lsos {

namespace {

using tinyxml2::XMLElement;

class Archive {
 public:
  Archive(const std::string& bytes, const std::string& file) : file_(file) {
    std::string why;
    archive_ = open_zip(bytes, why);
    if (archive_ != nullptr) return;
    throw InputError(
        {file, 0},
        fmt::format("cannot be unpacked: {}; the spreadsheet is cut short or damaged", why));
  }

  // Sum of the sizes in the archive's directory.
  std::size_t unpacked_bytes() const {
    std::size_t total = 0;
    const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
      zip_stat_t stat;
      if (zip_stat_index(archive_.get(), static_cast<zip_uint64_t>(i), 0, &stat) == 0) {
        total += stat.size;
      }
    }
    return total;
  }

  bool has(const std::string& name) const {
    return zip_name_locate(archive_.get(), name.c_str(), 0) >= 0;
  }

  // "" when there is no such file. Reads no more than the directory says.
  std::string unpacked(const std::string& name) const {
    zip_stat_t stat;
    if (zip_stat(archive_.get(), name.c_str(), 0, &stat) != 0) return "";
    const ZipEntry entry(zip_fopen(archive_.get(), name.c_str(), 0));
    std::string bytes(stat.size, '\0');
    const zip_int64_t count =
        entry == nullptr ? -1 : zip_fread(entry.get(), bytes.data(), bytes.size());
    if (count < 0 || static_cast<std::size_t>(count) != bytes.size()) {
      throw InputError({file_, 0}, fmt::format("{} in it cannot be unpacked: the spreadsheet is "
                                               "damaged",
                                               name));
    }
    return bytes;
  }

 private:
  std::string file_;
  ZipHandle archive_;
};

// Index 27 of "AB12", and 11 for its row; absent when the text is no cell.
struct CellIndex {
  std::size_t row = 0, column = 0;
};
std::optional<CellIndex> cell_index(std::string_view text) {
  constexpr std::size_t letters = 26, most = 1'000'000'000;
  CellIndex index;
  std::size_t i = 0;
  for (; i < text.size() && std::isupper(static_cast<unsigned char>(text[i])) != 0; ++i) {
    index.column = index.column * letters + static_cast<std::size_t>(text[i] - 'A') + 1;
    if (index.column > most) return {};
  }
  const std::string_view digits = text.substr(i);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), index.row);
  const bool is_cell = error == std::errc() && end == digits.data() + digits.size();
  if (!is_cell || index.row == 0 || index.column == 0) return {};
  --index.row;
  --index.column;
  return index;
}

// The blocks of <mergeCell ref="A2:A5"/> in a sheet's XML.
std::vector<MergedCells> merged_of_xlsx(const std::string& xml) {
  constexpr std::string_view element = "mergeCell ", key = "ref=\"";
  std::vector<MergedCells> merged;
  for (std::size_t at = xml.find(element); at != std::string::npos; at = xml.find(element, at)) {
    at += element.size();
    const std::size_t open = xml.find(key, at);
    if (open == std::string::npos) break;
    const std::size_t from = open + key.size(), to = std::min(xml.find('"', from), xml.size());
    const std::string_view range = std::string_view(xml).substr(from, to - from);
    const std::size_t colon = range.find(':');
    if (colon == std::string_view::npos) continue;
    const auto first = cell_index(range.substr(0, colon)),
               last = cell_index(range.substr(colon + 1));
    if (!first || !last || last->row < first->row || last->column < first->column) continue;
    merged.push_back(
        {first->row, first->column, last->row - first->row + 1, last->column - first->column + 1});
  }
  return merged;
}

// The text in quotes of a number format, "km/h" of 0.0" km/h".
std::string quoted_part(const std::string& code) {
  const std::size_t open = code.find('"');
  const std::size_t close = open == std::string::npos ? open : code.find('"', open + 1);
  if (close == std::string::npos) return "";
  return std::string(trimmed(std::string_view(code).substr(open + 1, close - open - 1)));
}

// Whether a number format shows a percentage: a % outside texts in quotes and behind backslashes.
bool is_percent(const std::string& code) {
  bool is_quoted = false;
  for (std::size_t i = 0; i < code.size(); ++i) {
    if (code[i] == '\\') {
      ++i;
    } else if (code[i] == '"') {
      is_quoted = !is_quoted;
    } else if (code[i] == '%' && !is_quoted) {
      return true;
    }
  }
  return false;
}

// What each cell style (an index of cellXfs) shows (ECMA-376-1, 18.8.10 and 18.8.30).
std::vector<ShownFormat> cell_styles(const std::string& xml) {
  constexpr int built_in_span = 46;  // [h]:mm:ss
  tinyxml2::XMLDocument styles;
  styles.Parse(xml.c_str());
  std::vector<ShownFormat> shown;
  if (styles.RootElement() == nullptr) return shown;
  std::map<int, ShownFormat> formats;
  formats[built_in_span].is_span = true;
  for (const int built_in_percent : {9, 10})
    formats[built_in_percent].unit = std::string("%");  // 0%, 0.00%
  if (const XMLElement* codes = child(*styles.RootElement(), "numFmts")) {
    for (const XMLElement* each = codes->FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      const std::string code = attribute(*each, "formatCode");
      const bool is_span = code.find("[h") != std::string::npos ||
                           code.find("[m") != std::string::npos ||
                           code.find("[s") != std::string::npos;
      formats[each->IntAttribute("numFmtId")] = {is_span,
                                                 is_percent(code) ? "%" : quoted_part(code)};
    }
  }
  if (const XMLElement* cells = child(*styles.RootElement(), "cellXfs")) {
    for (const XMLElement* each = cells->FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      shown.push_back(formats[each->IntAttribute("numFmtId")]);
    }
  }
  return shown;
}

// The value of an attribute in the text of a start tag; "" without one.
std::string_view value_in(std::string_view tag, std::string_view key) {
  const std::size_t at = tag.find(key);
  if (at == std::string_view::npos) return {};
  const std::string_view rest = tag.substr(at + key.size());
  return rest.substr(0, rest.find('"'));
}

// The cells <c r="B2" s="3"> whose style shows more than a number.
std::map<std::pair<std::size_t, std::size_t>, ShownFormat> formats_of_xlsx(
    const std::string& xml, const std::vector<ShownFormat>& styles) {
  std::map<std::pair<std::size_t, std::size_t>, ShownFormat> formats;
  for (std::size_t at = xml.find("<c "); at != std::string::npos; at = xml.find("<c ", at + 1)) {
    const std::size_t end = std::min(xml.find('>', at), xml.size());
    const std::string_view tag = std::string_view(xml).substr(at, end - at);
    const std::string_view style = value_in(tag, " s=\"");
    std::size_t index = 0;
    const auto [stop, error] = std::from_chars(style.data(), style.data() + style.size(), index);
    if (style.empty() || error != std::errc() || index >= styles.size()) continue;
    const auto cell = cell_index(value_in(tag, " r=\""));
    if (!cell || (!styles[index].is_span && styles[index].unit.empty())) continue;
    formats[{cell->row, cell->column}] = styles[index];
  }
  return formats;
}

void add_xlsx(const Archive& archive, WorkbookFacts& facts) {
  const std::vector<ShownFormat> styles = cell_styles(archive.unpacked("xl/styles.xml"));
  tinyxml2::XMLDocument workbook, links;
  workbook.Parse(archive.unpacked("xl/workbook.xml").c_str());
  links.Parse(archive.unpacked("xl/_rels/workbook.xml.rels").c_str());
  if (workbook.RootElement() == nullptr || links.RootElement() == nullptr) return;
  std::map<std::string, std::string> targets;
  for (const XMLElement* link = links.RootElement()->FirstChildElement(); link != nullptr;
       link = link->NextSiblingElement()) {
    targets[attribute(*link, "Id")] = attribute(*link, "Target");
  }
  const XMLElement& root = *workbook.RootElement();
  if (const XMLElement* properties = child(root, "workbookPr")) {
    const std::string value = attribute(*properties, "date1904");
    facts.counts_from_1904 = value == "1" || value == "true";
  }
  const XMLElement* sheets = child(root, "sheets");
  if (sheets == nullptr) return;
  for (const XMLElement* sheet = sheets->FirstChildElement(); sheet != nullptr;
       sheet = sheet->NextSiblingElement()) {
    const std::string target = targets[attribute(*sheet, "r:id")];
    const std::string name = target.starts_with('/') ? target.substr(1) : "xl/" + target;
    const std::string xml = archive.unpacked(name);
    facts.merged[attribute(*sheet, "name")] = merged_of_xlsx(xml);
    facts.formats[attribute(*sheet, "name")] = formats_of_xlsx(xml, styles);
  }
}

}  // namespace

WorkbookFacts workbook_facts(const std::string& bytes, const std::string& file,
                             std::size_t max_bytes) {
  const Archive archive(bytes, file);
  if (const std::size_t size = archive.unpacked_bytes(); size > max_bytes) {
    throw InputError({file, 0},
                     fmt::format("unpacks to {} MiB; a spreadsheet of a plan has at most "
                                 "{} MiB",
                                 size >> 20, max_bytes >> 20));
  }
  WorkbookFacts facts;
  facts.is_ods = archive.has("content.xml");
  if (!facts.is_ods && !archive.has("xl/workbook.xml")) {
    throw InputError({file, 0}, "is an archive, but no spreadsheet (XLSX or ODS) is in it");
  }
  if (facts.is_ods) {
    add_ods(archive.unpacked("content.xml"), archive.unpacked("styles.xml"), facts);
  } else {
    add_xlsx(archive, facts);
  }
  return facts;
}

}  // namespace lsos
