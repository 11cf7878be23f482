// The KML document of a plan that was read from something else.
#pragma once

#include <string>

#include "plan/kml_source.h"

namespace lsos {

struct DocumentLook {
  std::string name;  // "": that of the source
  std::string description = {};
  std::string target = {};  // body that a viewer shows it on, see KmlDocument
  std::vector<SourcePlacemark> places =
      {};                    // Points of a folder Places, which are no part of the plan
  bool has_folders = false;  // Placemarks lie in their folders, and rovers have colours
};

// Coordinates stay as they are written. A geometry with too few places or several parts is left
// out; it is reported when the plan is read.
std::string kml_of(const KmlSource& source, const DocumentLook& look = {});

}  // namespace lsos
