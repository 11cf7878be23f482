#include "interchange/map_tables.h"

#include <algorithm>
#include <utility>

#include "interchange/columns.h"

namespace lsos {

namespace {

// The column of that name; it is added when there is none.
std::size_t column_of(Table& table, const std::string& name) {
  const auto found = std::ranges::find(table.header, name);
  const auto index = static_cast<std::size_t>(found - table.header.begin());
  if (found == table.header.end()) table.header.push_back(name);
  return index;
}

void set_cell(Table& table, TableRow& row, const std::string& name, const std::string& text) {
  if (name.empty() || text.empty()) return;
  const std::size_t column = column_of(table, name);
  row.cells.resize(std::max(row.cells.size(), column + 1));
  row.cells[column] = text;
}

Table& table_for(const SourcePlacemark& placemark, const KmlSource& source,
                 std::vector<Table>& tables) {
  const std::string& file = placemark.file.empty() ? source.file : placemark.file;
  std::string name = placemark.folders.empty() ? "" : placemark.folders.back();
  if (!placemark.data.empty()) name = placemark.data.front().schema;
  const auto found = std::ranges::find_if(
      tables, [&](const Table& table) { return table.file == file && table.name == name; });
  if (found != tables.end()) return *found;
  Table table;
  table.file = file;
  table.name = std::move(name);
  const auto layer = std::ranges::find(source.layers, file, &KmlSource::Layer::file);
  if (layer != source.layers.end()) {
    table.body = layer->body;
    table.is_geographic = layer->is_geographic;
  }
  return tables.emplace_back(std::move(table));
}

}  // namespace

std::vector<Table> tables_of(const KmlSource& source) {
  std::vector<Table> tables;
  for (const SourcePlacemark& placemark : source.placemarks) {
    Table& table = table_for(placemark, source, tables);
    TableRow row{placemark.line, {}};
    set_cell(table, row, column::name, placemark.name);
    set_cell(table, row, column::description, placemark.description);
    for (const SourceField& field : placemark.plain_data) {
      set_cell(table, row, field.name, field.text);
    }
    for (const SourceData& data : placemark.data) {
      for (const SourceField& field : data.fields) set_cell(table, row, field.name, field.text);
    }
    if (!placemark.geometries.empty()) row.geometry = placemark.geometries.front();
    table.rows.push_back(std::move(row));
  }
  return tables;
}

}  // namespace lsos
