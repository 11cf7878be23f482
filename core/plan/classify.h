// Which Placemarks of a document are ours, and what each is.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_reader.h"

namespace lsos {

// A Placemark that is ours, with its fields; the Placemark lives in the KmlSource.
struct OurPlacemark {
  const SourcePlacemark* placemark = nullptr;
  // `schema` is its NAME. Fields that no NAME is known to have are left out.
  SourceData data;
  const EventDeclaration* event = nullptr;  // for an event
};

struct Classified {
  std::vector<OurPlacemark> missions;
  std::vector<OurPlacemark> rovers;
  std::vector<OurPlacemark> assets;
  std::vector<OurPlacemark> events;
  std::vector<OurPlacemark> unread;  // meant to be ours, with a fault in what they are
  int decoration_count = 0;
};

// What a Placemark is is said by its SchemaData, else by its field Type, else by the innermost
// folder that has such a name. A contradiction is a fault; so are a SchemaData that is nearly ours
// (it has a RoverId, Sequence or RoverType, or is called almost like something known) and two of
// ours in one Placemark. The rest is decoration, with a warning where it looks like ours.
Classified classify(const KmlSource& source, const Declarations& declarations, Faults& faults);

}  // namespace lsos
