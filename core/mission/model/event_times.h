// What the fields and the geometry of an event say about the time it takes, before the plan runs.
#pragma once

#include <optional>

#include "plan/plan.h"
#include "vehicle/vehicle_config.h"

namespace lsos {

// Sum of the durations among its fields.
double durations_s(const PlanEvent& event, const EventDeclaration& declaration);

// Speed of its drive: as its field requests, else the rover's cruise speed; at most what the rover
// can do.
double drive_speed_mps(const PlanEvent& event, const EventDeclaration& declaration,
                       const VehicleConfig& vehicle);

// Length from `at` through all points of the geometry, along the body's surface. `at` becomes the
// last point; absent, the length begins at the first.
double drawn_m(const PlanGeometry& geometry, const Body& body, std::optional<Geodetic>& at);

}  // namespace lsos
