// Point, LineString and Polygon of a Placemark as places on the body.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "plan/field_reader.h"
#include "plan/kml_source.h"
#include "plan/plan.h"

namespace lsos {

// "a LineString, a Point or no geometry".
std::string geometries_text(std::span<const GeometryKind> wanted);

// The one geometry of the Placemark, if it is of a wanted kind (`none` among them: it may have no
// geometry) and its coordinates are right. Otherwise reports a fault and returns nothing.
std::optional<PlanGeometry> read_geometry(const SourcePlacemark& placemark,
                                          std::span<const GeometryKind> wanted,
                                          const Subject& subject, Faults& faults);

}  // namespace lsos
