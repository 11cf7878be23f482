// A film, made of pictures by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lsos {

inline constexpr int film_pictures_a_second = 25;

// Written under another name, which is the file's only when it is complete; gone when it never is.
class Film {
 public:
  // An MP4. Throws InputError: ffmpeg is not installed; says how to.
  Film(const std::string& file, int width_px, int height_px);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Red, green and blue bytes, rows from the top. Throws OutputError when ffmpeg has ended.
  void add(std::span<const std::uint8_t> rgb);
  // Throws OutputError when ffmpeg could not do it.
  void finish();

 private:
  // Answers its exit code.
  int end();

  std::string file_, part_;
  pid_t child_ = -1;
  int to_child_ = -1;
};

}  // namespace lsos
