#include "base/random.h"

namespace lsos {

namespace {

std::uint64_t finalise(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t mix_key(std::uint64_t key, std::uint64_t part) {
  return finalise(key + 0x9e3779b97f4a7c15u + finalise(part));
}

std::uint64_t mix_key(std::uint64_t key, std::string_view part) {
  key = mix_key(key, part.size());  // so that ("ab", "c") and ("a", "bc") differ
  for (const char c : part) key = mix_key(key, static_cast<unsigned char>(c));
  return key;
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view rover_id, std::int64_t sequence,
                           std::string_view use)
    : state_(mix_key(
          mix_key(mix_key(mix_key(0, seed), rover_id), static_cast<std::uint64_t>(sequence)),
          use)) {}

std::uint64_t RandomStream::next() {
  state_ += 0x9e3779b97f4a7c15u;
  return finalise(state_);
}

}  // namespace lsos
