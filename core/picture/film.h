// A film, encoded from pictures by the program ffmpeg.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/child_process.h"

namespace lsos {

inline constexpr int film_frames_per_s = 25;

// Written under another name and renamed when complete; the destructor removes an incomplete film.
class Film {
 public:
  // Begins an MP4. Throws InputError, with advice, when ffmpeg is not installed.
  Film(const std::string& file, int width_px, int height_px);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Red, green and blue bytes, rows from the top. Throws OutputError when ffmpeg has ended.
  void add(std::span<const std::uint8_t> rgb);
  // Throws OutputError when ffmpeg has failed.
  void finish();

 private:
  std::string file_, part_;
  std::optional<ChildProcess> ffmpeg_;  // absent once it has ended
};

}  // namespace lsos
