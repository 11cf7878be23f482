// An event as it is read by itself, before what it says of others is resolved.
#pragma once

#include <string>
#include <vector>

#include "plan/kml_source.h"
#include "plan/plan.h"

namespace lsos {

struct DraftEvent {
  PlanEvent event;
  std::string subject;  // "Route 'leg 2'"
  bool drives = false;
  bool is_read = true;  // false: what it is cannot be read, only its name, rover and sequence
  // Rover and sequence are known, and no other event has them.
  bool is_placed = false;
  bool is_rover_known = false, is_sequence_known = false;
  bool has_default_label = false;  // "TYPE SEQUENCE"
  bool is_drive_known = true;      // false: faults leave open where to it drives, and whether
  // Fields that name other events; nullptr when absent. They live in the
  // PlanPlacemark.
  const SourceField* start_after = nullptr;
  const SourceField* on_failure = nullptr;
  // It says no OnFailure of its own, and takes that of its Rover or the mission.
  bool takes_default_on_failure = false;
  std::vector<std::string> defaults;
  // Its geometry's places where its coordinates may be meant with decimal commas, see
  // with_decimal_commas(); else empty.
  std::vector<Geodetic> comma_places;
};

// "Route 'leg 2' (SEV/3)"
std::string named(const DraftEvent& draft);

}  // namespace lsos
