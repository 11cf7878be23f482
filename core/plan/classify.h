// Decides which Placemarks of a document belong to the plan ("ours") and what each one is.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_reader.h"

namespace lsos {

// A Placemark of the plan, with its fields. The Placemark lives in the KmlSource.
struct PlanPlacemark {
  const SourcePlacemark* placemark = nullptr;
  // `schema` is its name: MissionInfo, Rover, Asset or an event type. Fields in plain Data that
  // such a Placemark does not have are left out.
  SourceData data;
  const EventDeclaration* event = nullptr;  // only for an event
};

struct Classified {
  std::vector<PlanPlacemark> missions;
  std::vector<PlanPlacemark> rovers;
  std::vector<PlanPlacemark> assets;
  std::vector<PlanPlacemark> events;
  std::vector<PlanPlacemark> unread;  // meant to be ours, but what they are is faulty
  int decoration_count = 0;
};

// The kind of a Placemark comes from its SchemaData, else from its field Type, else from the
// innermost folder with a known name. Faults are: a contradiction between these, a SchemaData that
// is nearly ours (it has a RoverId, Sequence or RoverType, or a name almost like a known one), and
// two of ours in one Placemark. All others are decoration, with a warning where they look like
// ours.
Classified classify(const KmlSource& source, const Declarations& declarations, Faults& faults);

}  // namespace lsos
