// The file of a plan that was edited: it is read before it is written.
#pragma once

#include <string>
#include <vector>

#include "edit/copied_events.h"
#include "lua/host/mission_files.h"

namespace lsos {

// Reads `bytes`, which are to be written to `file`. Throws InputError with the faults that the new
// plan would have: of `copies` at the lines of what was copied, which is there to be looked at.
MissionFiles read_new_plan(const std::string& bytes, const std::string& file,
                           const CopyPlaces& copies = {});

// Errors of a plan without faults that show when its rovers and assets are put on the ground, such
// as two in one place. Its events do not count.
std::vector<Fault> placing_faults(const MissionFiles& files);

// Tells the warnings of the new plan that the old one had not.
void tell_new_warnings(const Faults& old_faults, const Faults& new_faults);

}  // namespace lsos
