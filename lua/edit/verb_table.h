// The verbs of `lsos-host edit`, with the options that each takes.
#pragma once

#include <string>
#include <vector>

#include "edit/copied_events.h"
#include "lua/edit/edit_options.h"
#include "lua/host/mission_files.h"

namespace lsos {

// The verbs for the help, each with an example.
std::string verb_examples();

// Throws InputError where there is no such verb, it lacks something that it needs, or was given
// what another verb is for.
void check_verb(const EditOptions& options);

struct EditOutcome {
  std::string bytes;  // of the new file
  std::string what;   // "17 events renumbered"
  std::vector<std::string> warnings;
  CopyPlaces copies;  // see Editing
};

// `files`: the plan, without errors. Throws InputError, also where the plan is KMZ and the output
// is not, or the reverse.
EditOutcome edited(const EditOptions& options, const MissionFiles& files);

}  // namespace lsos
