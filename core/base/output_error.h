// A result that could not be written.
#pragma once

#include <stdexcept>

namespace lsos {

// A result was lost for a reason that the user did not write: a full disk, a closed pipe. Exit code
// 3. Where the place that was asked for is wrong, InputError says so.
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lsos
