// Reads back what a TableFile has written.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/table_file.h"

namespace lsos {

struct FileRow {
  std::vector<ColumnValue> values;  // in the order of the columns
  std::optional<Geodetic> place;
};

class TableFileReader {
 public:
  // All functions throw InputError: there is no such file or layer, or it cannot be read.
  explicit TableFileReader(const std::string& file);
  ~TableFileReader();
  TableFileReader(const TableFileReader&) = delete;
  TableFileReader& operator=(const TableFileReader&) = delete;

  std::vector<TableColumn> columns(const std::string& layer) const;
  // All rows in the order in which they were written.
  std::vector<FileRow> rows(const std::string& layer) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lsos
