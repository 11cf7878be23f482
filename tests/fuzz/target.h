// What each file of this folder defines: a function that takes any bytes and must come back. The
// name is libFuzzer's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace lsos::test {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Takes the bytes of an input one after the other; 0 when there is none left.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool is_empty() const { return size_ == 0; }
  std::uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::uint64_t number(int bytes) {
    std::uint64_t number = 0;
    for (int k = 0; k < bytes; ++k) number = number << 8 | byte();
    return number;
  }
  std::string rest() const { return text_of(data_, size_); }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

// `bytes` with the changes that an input lists: so a few bytes of input reach all of a large state.
std::string patched(std::string bytes, Bytes& changes);

// A folder that only this process uses, in memory where there is such a place. It is removed when
// the process ends.
const std::string& scratch_folder();
void write_scratch(const std::string& file, std::string_view bytes);

}  // namespace lsos::test
