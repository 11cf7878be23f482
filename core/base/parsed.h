// What reading a text gives.
#pragma once

#include <optional>
#include <string>

namespace lsos {

// A value, or why there is none ("'fast' is no number; a speed is allowed, such as '2 m/s'").
template <class T>
struct Parsed {
  std::optional<T> value;
  std::string why;

  explicit operator bool() const { return value.has_value(); }
};

}  // namespace lsos
