#include "fuzz/target.h"

#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

namespace lsos::test {

namespace {

namespace fs = std::filesystem;

struct Scratch {
  Scratch() {
    const fs::path memory = "/dev/shm";
    std::error_code ignored;
    const fs::path base = fs::is_directory(memory, ignored) ? memory : fs::temp_directory_path();
    path = (base / ("lsos-fuzz-" + std::to_string(::getpid()))).string();
    fs::create_directories(path);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string path;
};

template <class T>
void put(std::string& bytes, std::size_t at, T value) {
  const std::size_t count = std::min(sizeof value, bytes.size() - at);
  std::memcpy(bytes.data() + at, &value, count);
}

}  // namespace

std::string patched(std::string bytes, Bytes& changes) {
  constexpr double numbers[] = {std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity(),
                                -1.0,
                                0.0,
                                1e300,
                                -1e18,
                                5e-324};
  constexpr std::int64_t counts[] = {
      -1, 0, 1, 255, 65'536, 1LL << 31, 1LL << 40, std::numeric_limits<std::int64_t>::max()};
  while (!changes.is_empty() && !bytes.empty()) {
    const std::size_t at = changes.number(3) % bytes.size();
    const std::uint8_t kind = changes.byte(), value = changes.byte();
    switch (kind % 6) {
      case 0:
        bytes[at] = static_cast<char>(value);
        break;
      case 1:
        put(bytes, at, numbers[value % std::size(numbers)]);
        break;
      case 2:
        put(bytes, at, counts[value % std::size(counts)]);
        break;
      case 3:
        bytes.erase(at, value);
        break;
      case 4:
        bytes.insert(at, value, static_cast<char>(value));
        break;
      default:
        bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1u << (value % 8)));
    }
  }
  return bytes;
}

const std::string& scratch_folder() {
  static const Scratch scratch;
  return scratch.path;
}

void write_scratch(const std::string& file, std::string_view bytes) {
  std::ofstream out(scratch_folder() + "/" + file, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace lsos::test
