// Something that the rover has not, or that does not work, was told to do its work.
#pragma once

#include <stdexcept>

namespace lsos {

// Fails the event that asked, unless its script catches the error, with this as the reason: the
// rover or the plan is to blame and not the script, so no traceback is shown.
class EquipmentFault : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lsos
