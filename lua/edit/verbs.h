// What each verb of `lsos-host edit` does.
#pragma once

#include <string>
#include <vector>

#include "edit/copied_events.h"
#include "lua/edit/edit_options.h"
#include "lua/host/mission_files.h"

namespace lsos {

// What a verb works with.
struct Editing {
  const EditOptions& options;
  const MissionFiles& files;
  PlanDocument document;
  std::vector<std::string> warnings;
  CopyPlaces copies = {};  // that were made; other events keep their identity
};

// Each changes the document and returns what it did: "17 events renumbered". They throw InputError.
std::string edit_renumber(Editing& editing);
std::string edit_shift(Editing& editing);
std::string edit_enable(Editing& editing);
std::string edit_disable(Editing& editing);
std::string edit_merge(Editing& editing);
std::string edit_repeat(Editing& editing);
std::string edit_split(Editing& editing);
std::string edit_mirror(Editing& editing);

}  // namespace lsos
