#include "base/bounded_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>

#include "base/error.h"

namespace lsos {

namespace {

class Descriptor {
 public:
  // Opens a pipe without waiting for who writes into it, and makes no terminal the program's own.
  explicit Descriptor(const std::string& file)
      : number_(open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
  ~Descriptor() {
    if (is_open()) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

 private:
  int number_;
};

// "" for a regular file.
std::string kind_of(const struct stat& status) {
  if (S_ISREG(status.st_mode)) return "";
  if (S_ISDIR(status.st_mode)) return is_folder;
  if (S_ISFIFO(status.st_mode)) return "is a pipe";
  if (S_ISSOCK(status.st_mode)) return "is a socket";
  return "is a device or a terminal";
}

// Waits until something can be read; false after `silence_max`.
bool await_bytes(int descriptor, std::chrono::milliseconds silence_max) {
  pollfd wanted{descriptor, POLLIN, 0};
  const auto end = std::chrono::steady_clock::now() + silence_max;
  for (;;) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
    if (left.count() <= 0) return false;
    const int ready = poll(&wanted, 1, static_cast<int>(left.count()));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return true;  // reading says what is wrong
  }
}

}  // namespace

std::string too_large(std::size_t bytes_max) {
  constexpr int mib = 20;
  return bytes_max >> mib > 0 ? fmt::format("is larger than {} MiB", bytes_max >> mib)
                              : fmt::format("is larger than {} bytes", bytes_max);
}

Parsed<std::string> read_bounded(const std::string& file, const FileBounds& bounds) {
  const Descriptor in(file);
  struct stat status {};
  if (!in.is_open() || fstat(in.number(), &status) != 0) {
    return {{}, fmt::format("cannot be opened: {}", std::strerror(errno))};
  }
  const bool is_pipe = S_ISFIFO(status.st_mode);
  if (std::string kind = kind_of(status); !kind.empty() && !(is_pipe && bounds.may_be_pipe)) {
    return {{}, std::move(kind)};
  }
  const auto size = is_pipe ? std::size_t{0} : static_cast<std::size_t>(status.st_size);
  if (size > bounds.bytes_max) return {{}, too_large(bounds.bytes_max)};
  std::string bytes;
  bytes.reserve(size);
  std::string block(std::clamp<std::size_t>(size, 4096, std::size_t{1} << 20), '\0');
  for (;;) {
    if (is_pipe && !await_bytes(in.number(), bounds.silence_max)) {
      return {{},
              fmt::format("is a pipe into which nothing was written for {} s",
                          std::chrono::duration<double>(bounds.silence_max).count())};
    }
    const ssize_t count = read(in.number(), block.data(), block.size());
    if (count < 0 && (errno == EINTR || (is_pipe && errno == EAGAIN))) continue;
    if (count < 0) return {{}, fmt::format("cannot be read: {}", std::strerror(errno))};
    if (count == 0) return {std::move(bytes), ""};
    bytes.append(block, 0, static_cast<std::size_t>(count));
    // A file may grow while it is read, and a pipe has no size.
    if (bytes.size() > bounds.bytes_max) return {{}, too_large(bounds.bytes_max)};
  }
}

std::string read_named_file(const std::string& file) {
  FileBounds bounds;
  bounds.may_be_pipe = true;
  Parsed<std::string> bytes = read_bounded(file, bounds);
  if (!bytes) throw InputError({file}, std::move(bytes.why));
  return *std::move(bytes.value);
}

std::string other_than_file(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? kind_of(status) : "";
}

std::string larger_than(const std::string& path, std::size_t bytes_max) {
  struct stat status {};
  const bool is_larger =
      stat(path.c_str(), &status) == 0 && static_cast<std::uint64_t>(status.st_size) > bytes_max;
  return is_larger ? too_large(bytes_max) : "";
}

}  // namespace lsos
