// Notes of an estimate in a plan's document, for viewers: it stays the same plan.
#pragma once

#include <string>
#include <vector>

#include "edit/plan_document.h"

namespace lsos {

struct EventNote {
  const PlanEvent* event = nullptr;
  std::string html;                // behind what its balloon says
  std::string begin_utc, end_utc;  // ISO 8601; "": not known
};

// Puts notes into the Placemarks of the events: into their balloons, and as the time at which
// viewers show them, unless the Placemark has one. `kml`: of write_kml(), a document whose styles
// and folders are added; ids of its styles begin with "lsos-". What an earlier call wrote is
// replaced.
void put_notes(PlanDocument& document, const std::vector<EventNote>& notes, const std::string& kml);

// Takes away what put_notes() wrote. Returns whether there was anything.
bool erase_notes(PlanDocument& document);

}  // namespace lsos
