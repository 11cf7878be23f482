#include "interchange/ods_facts.h"

#include <tinyxml2.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/text.h"
#include "plan/xml_element.h"

namespace lsos {

namespace {

using tinyxml2::XMLElement;
using Units = std::map<std::string, std::string>;  // by the name of a cell style

std::size_t count_of(const XMLElement& element, const char* name) {
  constexpr int most = 2'000'000;
  const int count = element.IntAttribute(name, 1);
  return static_cast<std::size_t>(std::clamp(count, 1, most));
}

// The text behind the number of a format, "km/h" of <number:text> km/h</number:text>.
std::string unit_of_format(const XMLElement& format) {
  bool has_number = false;
  std::string unit;
  for (const XMLElement* part = format.FirstChildElement(); part != nullptr;
       part = part->NextSiblingElement()) {
    has_number = has_number || local_name(*part) == "number";
    const char* text = part->GetText();
    if (has_number && local_name(*part) == "text" && text != nullptr) unit += text;
  }
  return std::string(trimmed(unit));
}

// Cell styles with a number format that shows a unit.
void add_units(const XMLElement& styles, Units& formats, Units& units) {
  for (const XMLElement* each = styles.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    const std::string name = attribute(*each, "style:name");
    if (local_name(*each) == "number-style") formats[name] = unit_of_format(*each);
    if (local_name(*each) == "percentage-style") formats[name] = std::string("%");
    if (local_name(*each) != "style") continue;
    const std::string format = attribute(*each, "style:data-style-name");
    const std::string parent = attribute(*each, "style:parent-style-name");
    const auto found = formats.find(format);
    if (found != formats.end()) units[name] = found->second;
    if (format.empty() && units.contains(parent)) units[name] = units[parent];
  }
}

void add_units_of(const XMLElement* root, Units& formats, Units& units) {
  if (root == nullptr) return;
  for (const char* part : {"styles", "automatic-styles"}) {
    if (const XMLElement* styles = child(*root, part)) add_units(*styles, formats, units);
  }
}

// The rows of a table, also those in groups and headers.
void add_rows(const XMLElement& parent, std::vector<const XMLElement*>& rows) {
  for (const XMLElement* each = parent.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    if (local_name(*each) == "table-row") rows.push_back(each);
    if (local_name(*each) == "table-rows" || local_name(*each) == "table-row-group" ||
        local_name(*each) == "table-header-rows") {
      add_rows(*each, rows);
    }
  }
}

// Styles of columns, which cells without one of their own have.
std::vector<std::string> column_styles(const XMLElement& table) {
  constexpr std::size_t most = 20'000;
  std::vector<std::string> styles;
  for (const XMLElement* each = table.FirstChildElement(); each != nullptr;
       each = each->NextSiblingElement()) {
    if (local_name(*each) != "table-column") continue;
    const std::size_t count = count_of(*each, "table:number-columns-repeated");
    styles.resize(std::min(styles.size() + count, most),
                  attribute(*each, "table:default-cell-style-name"));
  }
  return styles;
}

// Appends the text of a paragraph, with its blanks and line ends, and of the spans and links in it.
void add_text(const XMLElement& paragraph, std::string& text) {
  constexpr std::size_t most = 100'000;
  for (const tinyxml2::XMLNode* node = paragraph.FirstChild();
       node != nullptr && text.size() < most; node = node->NextSibling()) {
    if (const tinyxml2::XMLText* words = node->ToText()) text += words->Value();
    const XMLElement* element = node->ToElement();
    if (element == nullptr || local_name(*element) == "annotation") continue;
    if (local_name(*element) == "s") text.append(std::min(count_of(*element, "text:c"), most), ' ');
    if (local_name(*element) == "tab") text += '\t';
    if (local_name(*element) == "line-break") text += '\n';
    add_text(*element, text);
  }
}

// The text of a cell without its comment; absent where it has none, or a value of its own.
std::optional<std::string> text_beside_comment(const XMLElement& cell) {
  const std::string type = attribute(cell, "office:value-type");
  if (child(cell, "annotation") == nullptr || (!type.empty() && type != "string")) return {};
  if (cell.Attribute("office:string-value") != nullptr) return {};
  std::string text;
  bool is_first = true;
  for (const XMLElement* part = cell.FirstChildElement(); part != nullptr;
       part = part->NextSiblingElement()) {
    if (local_name(*part) != "p") continue;
    if (!is_first) text += '\n';
    is_first = false;
    add_text(*part, text);
  }
  return text;
}

void add_table_facts(const XMLElement& table, const Units& units, WorkbookFacts& facts) {
  const std::string name = attribute(table, "table:name");
  std::vector<MergedCells>& merged = facts.merged[name];
  auto& formats = facts.formats[name];
  const std::vector<std::string> styles = column_styles(table);
  std::vector<const XMLElement*> lines;
  add_rows(table, lines);
  std::size_t row = 0;
  for (const XMLElement* line : lines) {
    const std::size_t rows_repeated = count_of(*line, "table:number-rows-repeated");
    std::size_t column = 0;
    for (const XMLElement* each = line->FirstChildElement(); each != nullptr;
         each = each->NextSiblingElement()) {
      const std::size_t rows = count_of(*each, "table:number-rows-spanned");
      const std::size_t columns = count_of(*each, "table:number-columns-spanned");
      if (rows > 1 || columns > 1) merged.push_back({row, column, rows, columns});
      const std::size_t repeated = count_of(*each, "table:number-columns-repeated");
      std::string style = attribute(*each, "table:style-name");
      if (style.empty() && column < styles.size()) style = styles[column];
      const auto unit = units.find(style);
      const std::string type = attribute(*each, "office:value-type");
      const bool is_percent = type == "percentage";
      const bool has_unit = unit != units.end() && !unit->second.empty();
      const bool is_shown = is_percent || (type == "float" && has_unit);
      const std::string shown(is_percent ? "%" : has_unit ? unit->second.c_str() : "");
      if (auto text = text_beside_comment(*each)) {
        facts.texts[name][{row, column}] = std::move(*text);
      }
      // Rows and columns that are repeated with a number in them are few.
      constexpr std::size_t most = 10'000;
      for (std::size_t i = 0; is_shown && i < std::min(rows_repeated, most); ++i) {
        for (std::size_t k = 0; k < std::min(repeated, most); ++k) {
          if (formats.size() >= 1'000'000) return;
          formats[{row + i, column + k}].unit = shown;
        }
      }
      column += repeated;
    }
    row += rows_repeated;
  }
}

}  // namespace

void add_ods(const std::string& content_xml, const std::string& styles_xml, WorkbookFacts& facts) {
  tinyxml2::XMLDocument content, common;
  content.Parse(content_xml.c_str());
  common.Parse(styles_xml.c_str());
  if (content.RootElement() == nullptr) return;
  Units formats, units;
  add_units_of(common.RootElement(), formats, units);
  add_units_of(content.RootElement(), formats, units);
  const XMLElement* body = child(*content.RootElement(), "body");
  const XMLElement* sheet = body == nullptr ? nullptr : child(*body, "spreadsheet");
  if (sheet == nullptr) return;
  for (const XMLElement* table = sheet->FirstChildElement(); table != nullptr;
       table = table->NextSiblingElement()) {
    if (local_name(*table) == "table") add_table_facts(*table, units, facts);
  }
}

}  // namespace lsos
