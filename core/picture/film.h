// A film, encoded from pictures by the program ffmpeg.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/child_process.h"
#include "base/whole_file.h"

namespace lsos {

inline constexpr int film_frames_per_s = 25;

// A WholeFile, which see: an incomplete film is never seen.
class Film {
 public:
  // Begins an MP4. Throws InputError, with advice, when ffmpeg is not installed.
  Film(const std::string& file, int width_px, int height_px);
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Red, green and blue bytes, rows from the top. Throws OutputError when ffmpeg has ended.
  void add(std::span<const std::uint8_t> rgb);
  // Throws OutputError when ffmpeg has failed.
  void finish();

 private:
  std::string name_;
  WholeFile file_;
  std::optional<ChildProcess> ffmpeg_;  // absent once it has ended; killed before the file goes
};

}  // namespace lsos
