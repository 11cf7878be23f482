// The run that the folder of a new one holds already.
#pragma once

#include <string>

namespace lsos {

// Throws InputError where results would be lost that the user may want: those of a run that was
// stopped and can go on, or, where the folder `is_default` and not named, those of another plan.
// Returns the plan whose run is replaced, "" for none that must be told.
std::string check_replaced_run(const std::string& folder, const std::string& plan, bool is_default,
                               bool is_forced);
// Reports the loss of results, with --quiet too.
void tell_of_replaced_run(const std::string& folder, const std::string& other_plan);

}  // namespace lsos
