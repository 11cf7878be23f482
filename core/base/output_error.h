// Error for a result that could not be written.
#pragma once

#include <stdexcept>

namespace lsos {

// A result was lost for a reason outside the input, such as a full disk or a closed pipe: exit code
// 3. An output path that is itself wrong is an InputError.
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace lsos
