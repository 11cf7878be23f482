// Well-known text of geometries, read by GDAL and written with the digits of the source.
#include <fmt/format.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <memory>

#include "interchange/places.h"
#include "terrain/raster/gdal_call.h"

namespace lsos {

namespace {

std::string curve_text(const OGRSimpleCurve& curve) {
  std::string text;
  for (int i = 0; i < curve.getNumPoints(); ++i) {
    text += fmt::format("{}{},{}", i == 0 ? "" : " ", curve.getX(i), curve.getY(i));
  }
  return text;
}

// "lon lat, lon lat" of "lon,lat,alt lon,lat,alt".
std::string wkt_points(const std::string& coordinates) {
  std::string text;
  for (std::string& tuple : tuples_of(coordinates)) {
    const std::size_t comma = tuple.find(',');
    const std::size_t end = std::min(tuple.find(',', comma + 1), tuple.size());
    if (comma == std::string::npos) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", tuple.substr(0, comma),
                        tuple.substr(comma + 1, end - comma - 1));
  }
  return text;
}

}  // namespace

Parsed<SourceGeometry> parse_wkt(const std::string& text) {
  const GdalSilence silence;
  OGRGeometry* made = nullptr;
  const OGRErr error = OGRGeometryFactory::createFromWkt(text.c_str(), nullptr, &made);
  const std::unique_ptr<OGRGeometry> geometry(made);
  if (error != OGRERR_NONE || geometry == nullptr) {
    return {{},
            "is no well-known text; a geometry is written as POINT (30.1 -89.9) or LINESTRING "
            "(30.1 -89.9, 30.2 -89.8)"};
  }
  if (geometry->IsEmpty()) return {SourceGeometry{}, {}};
  SourceGeometry found;
  // A collection of one part, as map tools write it, is that part.
  const OGRGeometry* whole = geometry.get();
  const bool is_multiple =
      OGR_GT_IsSubClassOf(wkbFlatten(whole->getGeometryType()), wkbGeometryCollection) != 0;
  if (is_multiple) {
    const OGRGeometryCollection& parts = *whole->toGeometryCollection();
    if (parts.getNumGeometries() > 1) {
      return {{},
              fmt::format("is a {} of {} parts; one POINT, LINESTRING or POLYGON is wanted, a row "
                          "for each part",
                          whole->getGeometryName(), parts.getNumGeometries())};
    }
    whole = parts.getGeometryRef(0);
  }
  switch (wkbFlatten(whole->getGeometryType())) {
    case wkbPoint:
      found.kind = "Point";
      found.coordinates = fmt::format("{},{}", whole->toPoint()->getX(), whole->toPoint()->getY());
      break;
    case wkbLineString:
      found.kind = "LineString";
      found.coordinates = curve_text(*whole->toLineString());
      break;
    case wkbPolygon: {
      found.kind = "Polygon";
      const OGRPolygon& polygon = *whole->toPolygon();
      found.coordinates = curve_text(*polygon.getExteriorRing());
      for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
        found.holes.push_back({curve_text(*polygon.getInteriorRing(i)), 0});
      }
      break;
    }
    default:
      return {{},
              fmt::format("is a {}; a POINT, LINESTRING or POLYGON is wanted",
                          whole->getGeometryName())};
  }
  return {std::move(found), {}};
}

std::string wkt_of(const SourceGeometry& geometry) {
  const std::string points = wkt_points(geometry.coordinates);
  if (geometry.kind == "Point") return fmt::format("POINT ({})", points);
  if (geometry.kind == "LineString") return fmt::format("LINESTRING ({})", points);
  if (geometry.kind != "Polygon") return "";
  std::string text = fmt::format("POLYGON (({})", points);
  for (const SourceGeometry::Ring& hole : geometry.holes) {
    text += fmt::format(", ({})", wkt_points(hole.coordinates));
  }
  return text + ")";
}

}  // namespace lsos
