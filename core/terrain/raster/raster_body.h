// Which body a map lies on.
#pragma once

#include <string>

#include "planet/body.h"
#include "terrain/raster/raster_name.h"

class OGRSpatialReference;

namespace lsos {

// A body with its own copy of the name, to which `body` refers: neither copied nor moved.
struct MapBody {
  std::string name;
  Body body;

  MapBody(std::string its_name, const Body& its_body) : name(std::move(its_name)), body(its_body) {
    body.name = name;
  }
  MapBody(const MapBody&) = delete;
  MapBody& operator=(const MapBody&) = delete;
};

// One of all_bodies() where the size of its datum fits; else a sphere of the datum's semi-major
// axis, named as the CRS names it, or "another body".
MapBody body_of(const OGRSpatialReference& crs, const RasterName& name);

// Refuses a CRS of another body.
void check_body(const OGRSpatialReference& crs, const Body& body, const RasterName& name);

// Whether a length is the body's radius, within 0.65 %.
bool is_radius_of(const Body& body, double length_m);

// Greatest distance of the body's ground from its reference surface, m.
double ground_limit_m(const Body& body);

}  // namespace lsos
