// Which Placemarks of a document are ours, and what each is.
#pragma once

#include <string>
#include <vector>

#include "plan/declaration.h"
#include "plan/kml_reader.h"

namespace lsos {

// A Placemark with the SchemaData that makes it ours; both live in the KmlSource.
struct OurPlacemark {
  const SourcePlacemark* placemark = nullptr;
  const SourceData* data = nullptr;
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

// A SchemaData that is nearly ours (it has a RoverId, Sequence or RoverType, or is called almost
// like something known) is a fault; so are two of ours in one Placemark. The rest is decoration.
Classified classify(const KmlSource& source, const Declarations& declarations, Faults& faults);

}  // namespace lsos
