// Column titles, which GIS tools show in place of the names.
#include <fmt/format.h>

#include "base/qgis_style_table.h"
#include "record/column_titles.h"
#include "record/gpkg.h"

namespace lsos::gpkg {

// The tables follow OGC 12-128r18, annex F.9.
void add_titles(GDALDataset& dataset) {
  run_sql(dataset,
          "CREATE TABLE gpkg_data_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, "
          "name TEXT, title TEXT, description TEXT, mime_type TEXT, constraint_name TEXT, "
          "CONSTRAINT pk_gdc PRIMARY KEY (table_name, column_name), "
          "CONSTRAINT gdc_tn UNIQUE (table_name, name))");
  run_sql(dataset,
          "CREATE TABLE gpkg_data_column_constraints (constraint_name TEXT NOT NULL, "
          "constraint_type TEXT NOT NULL, value TEXT, min NUMERIC, min_is_inclusive BOOLEAN, "
          "max NUMERIC, max_is_inclusive BOOLEAN, description TEXT, "
          "CONSTRAINT gdcc_ntv UNIQUE (constraint_name, constraint_type, value))");
  run_sql(dataset,
          "CREATE TABLE IF NOT EXISTS gpkg_extensions (table_name TEXT, column_name TEXT, "
          "extension_name TEXT NOT NULL, definition TEXT NOT NULL, scope TEXT NOT NULL, "
          "CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name))");
  for (const char* table : {"gpkg_data_columns", "gpkg_data_column_constraints"}) {
    run_sql(dataset, fmt::format("INSERT INTO gpkg_extensions VALUES ('{}', NULL, 'gpkg_schema', "
                                 "'http://www.geopackage.org/spec/#extension_schema', "
                                 "'read-write')",
                                 table));
  }
  for (const LayerSpec& layer : contract_layers()) {
    for (const ColumnSpec& column : layer.columns) {
      const ColumnTitle title = column_title(layer.name, column.name);
      run_sql(dataset,
              fmt::format("INSERT INTO gpkg_data_columns (table_name, column_name, name, "
                          "title, description) VALUES ({}, {}, {}, {}, {})",
                          sql_text(layer.name), sql_text(column.name), sql_text(title.title),
                          sql_text(title.title), sql_text(title.meaning)));
    }
  }
}

}  // namespace lsos::gpkg
