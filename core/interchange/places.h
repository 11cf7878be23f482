// Places by name, to which rows of a sheet or lines of an outline refer.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/parsed.h"
#include "interchange/columns.h"
#include "interchange/notes.h"
#include "plan/kml_source.h"

namespace lsos {

// A named feature of a map or row of a sheet.
struct NamedPlace {
  SourceGeometry geometry;
  Place place;  // where it stands
  mutable bool is_used = false;
  bool is_owner = false;  // a rover or an asset
};

class PlaceNames {
 public:
  void add(const std::string& name, NamedPlace place);
  // The geometry that a text means: the name of a place, or several as "A; B; C", which make a line
  // through all their points; or coordinates "lon, lat", several as "lon, lat; lon, lat"; or
  // well-known text.
  Parsed<SourceGeometry> geometry(const std::string& text) const;
  // Whether the text names several points, which a rover visits one after the other.
  bool is_way(const std::string& text) const;
  bool has(const std::string& name) const { return !known_name(name).empty(); }
  bool has_exactly(const std::string& name) const { return places_.contains(name); }
  // Coordinates of the one Point of that name, "" where there is none; and the name of a Point at a
  // place by its key, see place_key().
  std::string point(const std::string& name) const;
  std::string name_at(const std::string& key) const;
  // "; did you mean 'Ridge'?", or "".
  std::string hint(const std::string& name) const;
  // "'ridge' is taken for 'Ridge'": texts that were understood in another case of letters.
  const std::vector<std::string>& notes() const { return notes_.all(); }
  // Points that something has referred to, but for rovers and assets, in the order of their names.
  std::vector<SourcePlacemark> used_points() const;
  // Those that nothing has referred to, in the order of their names.
  std::vector<std::string> unused() const;

 private:
  Parsed<SourceGeometry> one(const std::string& text) const;
  std::string how_to_write(const std::string& text) const;
  std::vector<std::string> names() const;
  // The name that a text means, in any case of letters; "" when it means none.
  std::string known_name(const std::string& text) const;

  std::multimap<std::string, NamedPlace> places_;
  mutable Notes notes_;
};

// The place that a row states itself: the feature's geometry, WKT, or Lon and Lat. A geometry
// without a kind when it states none. Reports wrong numbers.
SourceGeometry own_geometry(const Table& table, const TableRow& row, const Columns& columns,
                            Faults& faults);

// Reads well-known text, such as "LINESTRING (30.1 -89.9, 30.2 -89.9)".
Parsed<SourceGeometry> parse_wkt(const std::string& text);
// A geometry as well-known text; its coordinates keep their digits.
std::string wkt_of(const SourceGeometry& geometry);
// "30.1,-89.9" of a tuple "30.100,-89.9,12": equal for equal places. "" when it is no place.
std::string place_key(const std::string& tuple);
// The tuples "lon,lat" of a text of coordinates.
std::vector<std::string> tuples_of(const std::string& coordinates);

}  // namespace lsos
