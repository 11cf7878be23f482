#include "base/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "base/output_error.h"
#include "base/visible_text.h"

namespace lsos {

namespace {

[[noreturn]] void lose_results() {
  const char* why = errno == 0 ? "a write failed" : std::strerror(errno);
  throw OutputError(fmt::format("standard output: the result is not whole: {}", why));
}

// Without memory for it the text is left out.
std::string visible_or_nothing(std::string_view text) noexcept {
  try {
    return visible_text(text);
  } catch (const std::bad_alloc&) {
    return {};
  }
}

void write_raw(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace

void open_missing_streams() {
  // Each open() takes the lowest free descriptor. It is opened for reading, so that printing to it
  // fails.
  for (int file = 0; file <= STDERR_FILENO;) {
    file = ::open("/dev/null", O_RDONLY);
    if (file < 0) return;
    if (file > STDERR_FILENO) ::close(file);
  }
}

void write_result(std::string_view text) {
  const std::string visible = visible_text(text);
  errno = 0;
  if (std::fwrite(visible.data(), 1, visible.size(), stdout) != visible.size()) lose_results();
}

void flush_results() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) lose_results();
}

void write_message(std::string_view text) noexcept { write_raw(visible_or_nothing(text)); }

void redraw_message(std::string_view line) noexcept {
  write_raw("\r");
  write_message(line);
  write_raw("\x1b[K");
}

}  // namespace lsos
