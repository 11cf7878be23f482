// Seeded random numbers. The key of a stream is its purpose, not the time of its creation, so
// results do not depend on the order in which streams are created.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/archive.h"

namespace lsos {

// SplitMix64 (Steele, Lea, Flood 2014): 64 bits of state, passes BigCrush.
class RandomStream {
 public:
  RandomStream() = default;
  explicit RandomStream(std::uint64_t key) : state_(key) {}
  RandomStream(std::uint64_t seed, std::string_view rover_id, std::int64_t sequence,
               std::string_view use);

  std::uint64_t next();
  // Uniform in [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  // Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  void archive(Archive& a) { LSOS_ARCHIVE(a, state_); }

 private:
  std::uint64_t state_ = 0;
};

// A well-mixed key from two parts, the same on every machine.
std::uint64_t mix_key(std::uint64_t key, std::uint64_t part);
std::uint64_t mix_key(std::uint64_t key, std::string_view part);

}  // namespace lsos
