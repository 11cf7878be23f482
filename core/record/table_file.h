// A GeoPackage of tables whose columns are known at run time alone.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.h"
#include "planet/body.h"
#include "record/layers.h"

namespace lsos {

struct TableColumn {
  std::string name;
  ColumnType type = ColumnType::real;
};

struct TableLayer {
  std::string name;
  LayerGeometry geometry = LayerGeometry::none;
  std::vector<TableColumn> columns;
};

class TableFile {
 public:
  // Writes a new file in place of `file`, which is replaced when all is written. `crs`: as in Body.
  // All functions throw OutputError.
  TableFile(const std::string& file, const std::string& crs);
  // Without `finish` there is no file, and an old one stays.
  ~TableFile();
  TableFile(const TableFile&) = delete;
  TableFile& operator=(const TableFile&) = delete;

  // Begins the next layer.
  void begin(const TableLayer& layer);
  // A row of the layer, in the order of its columns.
  void write(const std::vector<ColumnValue>& row, const std::optional<Geodetic>& place = {});
  void finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lsos
