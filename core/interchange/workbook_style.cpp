#include "interchange/workbook_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "plan/kmz_archive.h"

namespace lsos {

namespace {

// In characters of the sheet's font; beside the text there is room for the arrow of a filter.
constexpr std::size_t width_least = 8, width_most = 60, width_beside = 2;

std::size_t characters(const std::string& text) {
  const auto begins_one = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  return static_cast<std::size_t>(std::ranges::count_if(text, begins_one));
}

std::string columns_xml(const Table& table) {
  std::string xml = "<cols>\n";
  for (std::size_t i = 0; i < table.header.size(); ++i) {
    std::size_t width = characters(table.header[i]);
    for (const TableRow& row : table.rows) width = std::max(width, characters(cell(row, i)));
    xml += fmt::format("<col min=\"{0}\" max=\"{0}\" width=\"{1}\" customWidth=\"1\"/>\n", i + 1,
                       std::clamp(width + width_beside, width_least, width_most));
  }
  return xml + "</cols>";
}

constexpr const char* frozen_header =
    "<sheetViews>\n<sheetView workbookViewId=\"0\">\n<pane ySplit=\"1\" topLeftCell=\"A2\" "
    "activePane=\"bottomLeft\" state=\"frozen\"/>\n</sheetView>\n</sheetViews>\n";

// From the first `begin` through the first `end` behind it; absent: it is not there.
struct Part {
  std::size_t at, length;
};
std::optional<Part> part(const std::string& xml, const std::string& begin, const std::string& end) {
  const std::size_t from = xml.find(begin);
  const std::size_t to = from == std::string::npos ? from : xml.find(end, from);
  if (to == std::string::npos) return {};
  return Part{from, to + end.size() - from};
}

// Adds an element to a list such as <fonts count="1">; its index there. Absent: there is no list.
std::optional<int> add_to_list(std::string& xml, const std::string& list,
                               const std::string& element) {
  const std::string head = "<" + list + " count=\"", tail = "</" + list + ">";
  const auto whole = part(xml, head, tail);
  if (!whole) return {};
  const std::size_t number = whole->at + head.size(), number_end = xml.find('"', number);
  int count = 0;
  std::from_chars(xml.data() + number, xml.data() + number_end, count);
  xml.insert(whole->at + whole->length - tail.size(), element + "\n");
  xml.replace(number, number_end - number, std::to_string(count + 1));
  return count;
}

// Number of a bold style in styles.xml, which is added.
std::optional<int> add_bold(std::string& xml) {
  const auto font = add_to_list(
      xml, "fonts",
      "<font>\n<b/>\n<name val=\"Arial\"/>\n<family val=\"2\"/>\n<sz val=\"10\"/>\n</font>");
  if (!font) return {};
  return add_to_list(
      xml, "cellXfs",
      fmt::format("<xf numFmtId=\"164\" fontId=\"{}\" xfId=\"0\" applyFont=\"1\"/>", *font));
}

void style_sheet(std::string& xml, const Table& table, int bold) {
  if (const auto first = part(xml, "<row r=\"1\">", "</row>")) {
    std::string row = xml.substr(first->at, first->length);
    const std::string of_text = "\" t=\"s\">", styled = fmt::format("\" s=\"{}\" t=\"s\">", bold);
    for (std::size_t at = row.find(of_text); at != std::string::npos;
         at = row.find(of_text, at + styled.size())) {
      row.replace(at, of_text.size(), styled);
    }
    xml.replace(first->at, first->length, row);
  }
  if (const auto columns = part(xml, "<cols>", "</cols>")) {
    xml.replace(columns->at, columns->length, frozen_header + columns_xml(table));
  }
}

}  // namespace

std::string styled_workbook(const std::string& xlsx, const std::vector<Table>& tables) {
  constexpr std::size_t bytes_max = std::size_t{1} << 32;
  std::string styled = xlsx;
  // Absent: the workbook has no such part.
  const auto read = [&](const std::string& name) -> std::optional<std::string> {
    KmzArchive archive(styled, name, bytes_max);
    if (!archive.has(name)) return {};
    return archive.unpacked(name);
  };
  const auto write = [&](const std::string& name, const std::string& bytes) {
    styled = repacked_zip(styled, name, bytes);
  };
  const std::string styles_name = "xl/styles.xml", workbook_name = "xl/workbook.xml";
  std::optional<std::string> styles = read(styles_name), workbook = read(workbook_name);
  if (!styles || !workbook) return xlsx;
  const std::optional<int> bold = add_bold(*styles);
  const std::size_t sheets = workbook->find("<sheets>");
  if (!bold || sheets == std::string::npos) return xlsx;
  write(styles_name, *styles);
  // The views of sheets are of a window of the workbook.
  if (workbook->find("<bookViews>") == std::string::npos) {
    workbook->insert(sheets, "<bookViews>\n<workbookView/>\n</bookViews>\n");
    write(workbook_name, *workbook);
  }
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string name = fmt::format("xl/worksheets/sheet{}.xml", i + 1);
    std::optional<std::string> sheet = read(name);
    if (!sheet) return xlsx;
    style_sheet(*sheet, tables[i], *bold);
    write(name, *sheet);
  }
  return styled;
}

}  // namespace lsos
