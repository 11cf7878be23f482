// Cells of a log as values. A log may come from anyone: what no log of lsos-host holds is an
// InputError that names the layer, the row and the column. Only for use in this folder.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "record/layers.h"
#include "record/sqlite.h"

namespace lsos {

// The rows of one layer, in fid order.
class LayerRows {
 public:
  // `where`: a condition on them; "": all.
  LayerRows(const sqlite::Database& database, const LayerSpec& layer,
            const std::string& where = "");

  // Goes to the next row.
  bool next();

  std::int64_t fid() const { return fid_; }
  // `column`: its number in the layer.
  ColumnValue value(std::size_t column) const;
  // ISO WKB, little-endian; "" is NULL.
  std::string geometry_wkb() const;
  // The places of the geometry: none where it is NULL, one of a point.
  std::vector<Geodetic> places() const;

  // Says that a value of this row cannot be.
  [[noreturn]] void refuse(std::string_view column, const std::string& what) const;

 private:
  std::string_view wkb() const;
  void check_number(const ColumnSpec& column, double number) const;

  const sqlite::Database& database_;
  const LayerSpec& layer_;
  sqlite::Query query_;
  std::int64_t fid_ = 0;
};

// Throws InputError where the database has no such layer: a table with these columns, rows that are
// numbered by fid and, where the layer has one, the column of geometry.
void check_layer(const sqlite::Database& database, const LayerSpec& layer);
// The same for all layers of the contract; and that it is a GeoPackage.
void check_layers(const sqlite::Database& database);
bool has_table(const sqlite::Database& database, std::string_view name);

}  // namespace lsos
