#include "base/archive.h"

#include <fmt/format.h>

namespace lsos {

Archive Archive::locator(std::size_t offset) {
  Archive a = writer();
  a.offset_ = offset;
  return a;
}

std::string_view Archive::take_name(std::string_view& names) {
  const std::size_t comma = std::min(names.find(','), names.size());
  const std::string_view name = names.substr(0, comma);
  names.remove_prefix(std::min(comma + 2, names.size()));  // and the blank after the comma
  return name;
}

std::string Archive::path() const {
  std::string text;
  for (const Step& step : path_) {
    if (step.name.empty()) {
      text += fmt::format("[{}]", step.number);
    } else {
      text += fmt::format("{}{}", text.empty() ? "" : ".", step.name);
    }
  }
  return text;
}

void Archive::refuse(const std::string& why) const {
  throw Mismatch(path_.empty() ? why : fmt::format("{}: {}", path(), why));
}

void Archive::raw(void* data, std::size_t size) {
  if (!reading_) {
    const bool is_before = offset_ && bytes_.size() <= *offset_;
    bytes_.append(static_cast<const char*>(data), size);
    if (is_before && bytes_.size() > *offset_) located_ = path();
    return;
  }
  if (bytes_.size() - position_ < size) refuse("saved state ends too early");
  std::memcpy(data, bytes_.data() + position_, size);
  position_ += size;
}

Archive& Archive::operator()(bool& value) {
  std::uint8_t byte = value ? 1 : 0;
  (*this)(byte);
  if (byte > 1) refuse("saved state holds a truth value that is neither 0 nor 1");
  value = byte == 1;
  return *this;
}

Archive& Archive::operator()(SimTime& value) {
  constexpr std::int64_t least_us = -1'000'000'000'000, greatest_us = 10'000'000'000'000'000;
  std::int64_t count = value.count();
  (*this)(count);
  if (reading_ && (count < least_us || count > greatest_us)) {
    refuse("saved state holds a time that no mission has");
  }
  value = SimTime{count};
  return *this;
}

std::size_t Archive::size(std::size_t size) {
  auto count = static_cast<std::uint64_t>(size);
  (*this)(count);
  // Every element takes at least a byte; a larger count is damage and must not allocate.
  if (reading_ && count > bytes_.size() - position_) refuse("saved state ends too early");
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
    refuse(fmt::format("saved state holds '{}' where '{}' belongs", found, word));
  }
  return *this;
}

}  // namespace lsos
