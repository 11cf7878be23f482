// Error of a command to equipment that the rover does not have or that does not work.
#pragma once

#include <stdexcept>

namespace lsos {

// Fails the calling event with this as the reason, unless its script catches the error. The rover
// or the plan is to blame and not the script, so no traceback is shown.
class EquipmentFault : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lsos
