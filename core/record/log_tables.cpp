// Whether a database has the tables of a log.
#include <fmt/format.h>

#include <set>

#include "base/error.h"
#include "record/log_cells.h"

namespace lsos {

namespace {

// "GPKG", and what it was before version 1.2.
constexpr std::int64_t application_ids[] = {0x47504b47, 0x47503130, 0x47503131};

// What SQLite calls it: "table", "view", "virtual" or "shadow"; "": it has none of that name.
std::string entry_type(const sqlite::Database& database, std::string_view name) {
  sqlite::Query query(database,
                      fmt::format("SELECT type FROM pragma_table_list WHERE schema = 'main' AND "
                                  "name = '{}'",
                                  name));
  return query.next() ? std::string(query.text(0)) : "";
}

[[noreturn]] void refuse(const sqlite::Database& database, const std::string& what) {
  throw InputError({database.file()}, what);
}

}  // namespace

bool has_table(const sqlite::Database& database, std::string_view name) {
  return entry_type(database, name) == "table";
}

void check_layer(const sqlite::Database& database, const LayerSpec& layer) {
  const std::string type = entry_type(database, layer.name);
  if (type.empty()) {
    refuse(database, fmt::format("no log of lsos-host: it has no layer '{}'", layer.name));
  }
  if (type != "table") {
    refuse(database, fmt::format("no log of lsos-host: its layer '{}' is no table but a {}",
                                 layer.name, type == "view" ? "view" : "virtual table"));
  }
  std::set<std::string, std::less<>> names;
  bool is_numbered = false;
  sqlite::Query query(
      database,
      fmt::format("SELECT name, type, pk, hidden FROM pragma_table_xinfo('{}')", layer.name));
  while (query.next()) {
    const std::string name(query.text(0));
    if (query.integer(3) != 0) {
      refuse(database, fmt::format("no log of lsos-host: column '{}' of layer '{}' is computed",
                                   name, layer.name));
    }
    is_numbered |= name == "fid" && query.text(1) == "INTEGER" && query.integer(2) == 1;
    names.insert(name);
  }
  if (!is_numbered) {
    refuse(database, fmt::format("no log of lsos-host: the rows of layer '{}' are not numbered by "
                                 "'fid'",
                                 layer.name));
  }
  const auto want = [&](std::string_view name) {
    if (names.contains(name)) return;
    refuse(database, fmt::format("no log of this version of lsos-host: layer '{}' has no column "
                                 "'{}'",
                                 layer.name, name));
  };
  for (const ColumnSpec& column : layer.columns) want(column.name);
  if (layer.geometry != LayerGeometry::none) want("geom");
}

void check_layers(const sqlite::Database& database) {
  sqlite::Query query(database, "PRAGMA application_id");
  const std::int64_t id = query.next() ? query.integer(0) : 0;
  if (std::ranges::find(application_ids, id) == std::end(application_ids)) {
    refuse(database,
           fmt::format("no log of lsos-host: it is a database, but no GeoPackage (application_id "
                       "is {})",
                       id));
  }
  for (const LayerSpec& layer : contract_layers()) check_layer(database, layer);
}

}  // namespace lsos
