#include "base/archive.h"

#include <fmt/format.h>

namespace lsos {

void Archive::raw(void* data, std::size_t size) {
  if (!reading_) {
    bytes_.append(static_cast<const char*>(data), size);
    return;
  }
  if (bytes_.size() - position_ < size) throw Mismatch("saved state ends too early");
  std::memcpy(data, bytes_.data() + position_, size);
  position_ += size;
}

Archive& Archive::operator()(bool& value) {
  std::uint8_t byte = value ? 1 : 0;
  (*this)(byte);
  if (byte > 1) throw Mismatch("saved state holds a truth value that is neither 0 nor 1");
  value = byte == 1;
  return *this;
}

std::size_t Archive::size(std::size_t size) {
  auto count = static_cast<std::uint64_t>(size);
  (*this)(count);
  // Every element takes at least a byte; a larger count is damage and must not allocate.
  if (reading_ && count > bytes_.size() - position_) throw Mismatch("saved state ends too early");
  return static_cast<std::size_t>(count);
}

Archive& Archive::operator()(std::string& value) {
  value.resize(size(value.size()));
  raw(value.data(), value.size());
  return *this;
}

Archive& Archive::tag(std::string_view word) {
  std::string found(word);
  (*this)(found);
  if (found != word) {
    throw Mismatch(fmt::format("saved state holds '{}' where '{}' belongs", found, word));
  }
  return *this;
}

}  // namespace lsos
