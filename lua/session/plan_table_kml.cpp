// Writes the KML document of a plan that was read from a table, or from the layers of a GIS.
#include <algorithm>
#include <sstream>

#include "lua/host/plan_table.h"
#include "plan/kml_writer.h"

namespace lsos {

namespace {

// Places in a text of coordinates.
std::vector<Geodetic> places_of(const std::string& text) {
  std::vector<Geodetic> places;
  std::istringstream points(text);
  for (std::string point; points >> point;) {
    double lon = 0, lat = 0;
    char comma = 0;
    std::istringstream(point) >> lon >> comma >> lat;
    places.push_back(geodetic_from_degrees(lon, lat));
  }
  return places;
}

// Whether a geometry can be written as KML. One with too few places or several parts cannot; it is
// reported when the plan is read.
bool is_whole(const SourceGeometry& geometry) {
  const std::size_t places = places_of(geometry.coordinates).size();
  if (geometry.kind == "Point") return places == 1;
  if (geometry.kind == "LineString") return places >= 2;
  return geometry.kind == "Polygon" && places >= 3;
}

// Data of a Placemark. A feature of a layer has no SchemaData; its field Type, or the name of its
// layer, states its kind.
SourceData data_of(const SourcePlacemark& placemark) {
  if (!placemark.data.empty()) return placemark.data.front();
  SourceData data{"", placemark.folders.empty() ? "" : placemark.folders.back(), {}, 0};
  for (const SourceField& field : placemark.plain_data) {
    if (field.name == "Type") data.schema = field.text;
    if (field.name != "name") data.fields.push_back(field);
  }
  return data;
}

}  // namespace

std::string kml_of(const KmlSource& source) {
  KmlDocument document;
  document.name = source.file;
  for (const SourcePlacemark& from : source.placemarks) {
    const SourceData data = data_of(from);
    const auto known = std::ranges::find(document.schemas, data.schema, &KmlSchema::id);
    KmlSchema& schema =
        known != document.schemas.end()
            ? *known
            : document.schemas.emplace_back(KmlSchema{data.schema, data.schema, {}});
    KmlPlacemark placemark;
    placemark.name = from.name;
    placemark.schema_id = data.schema;
    for (const SourceField& field : data.fields) {
      placemark.data.emplace_back(field.name, field.text);
      if (std::ranges::find(schema.fields, field.name, &KmlField::name) == schema.fields.end()) {
        schema.fields.push_back({field.name, "string", ""});
      }
    }
    for (const SourceGeometry& geometry : from.geometries) {
      if (!is_whole(geometry)) continue;
      placemark.geometry.kind = geometry.kind == "Point"     ? KmlGeometryKind::point
                                : geometry.kind == "Polygon" ? KmlGeometryKind::polygon
                                                             : KmlGeometryKind::line;
      placemark.geometry.points = places_of(geometry.coordinates);
      for (const SourceGeometry::Ring& hole : geometry.holes) {
        placemark.geometry.holes.push_back(places_of(hole.coordinates));
      }
    }
    document.placemarks.push_back(std::move(placemark));
  }
  return write_kml(document);
}

}  // namespace lsos
