// What the columns of a table mean: the fields of a plan and the few columns that are none.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "interchange/table.h"
#include "plan/declaration.h"

namespace lsos {

// Columns that are no fields of a plan's things.
namespace column {
inline constexpr const char* type = "Type";
inline constexpr const char* name = "name";
inline constexpr const char* description = "description";
inline constexpr const char* day = "Day";
inline constexpr const char* place = "Place";
inline constexpr const char* lon = "Lon";
inline constexpr const char* lat = "Lat";
inline constexpr const char* wkt = "WKT";
}  // namespace column

struct SheetColumn {
  std::size_t index = 0;
  std::string unit;  // of the header, as written: "km/h"; "": none
};

class Columns {
 public:
  // Finds columns by their headers: "Speed", "speed", "Rover ID", "Speed (km/h)", and everyday
  // words such as "Rover", "Start" and "Notes". Reports headers that stand twice, and warns of
  // those that mean nothing though their column is filled.
  Columns(const Table& table, const Declarations& declarations, Faults& faults);

  // Finds a column by its canonical name: a field as plans write it, or one of namespace column.
  const SheetColumn* find(const std::string& name) const;
  const std::map<std::string, SheetColumn>& all() const { return columns_; }

  // Whether places are in columns whose CRS nobody knows, which has been reported.
  bool has_unknown_crs() const { return has_unknown_crs_; }

  // Text of the row's cell in that column; "" when there is none.
  std::string text(const TableRow& row, const std::string& name) const;

 private:
  std::map<std::string, SheetColumn> columns_;
  bool has_unknown_crs_ = false;
};

// The canonical name that a header without a unit means; "" when it means none.
std::string column_meant(const std::string& header, const Declarations& declarations);

// How many of these texts are headers that mean something.
std::size_t known_headers(const std::vector<std::string>& cells, const Declarations& declarations);

// The NAME that a text means, in any case of letters, with or without blanks and a plural s:
// "route", "Path plan route", "Rovers"; "" when it means none.
std::string name_meant(const std::string& text, const Declarations& declarations);
// What a sheet or layer is called after, "Rover" of Rovers; "" where it is called otherwise. Of a
// sheet the last word counts: "mission-Rovers" of a file "mission-Rovers.csv".
std::string type_of_sheet(const Table& table, const Declarations& declarations);
// MissionInfo, Rover, Asset and the events.
std::vector<std::string> plan_names(const Declarations& declarations);

}  // namespace lsos
