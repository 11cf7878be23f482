#include "picture/film.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/output_error.h"

namespace lsos {

namespace {

std::string ffmpeg() {
  std::string program = program_in_path("ffmpeg");
  if (!program.empty()) return program;
  throw InputError({},
                   "films are made by the program ffmpeg, which is not installed: apt-get "
                   "install ffmpeg");
}

}  // namespace

Film::Film(const std::string& file, int width_px, int height_px) : name_(file), file_(file) {
  const std::vector<std::string> words{ffmpeg(),
                                       "-loglevel",
                                       "error",
                                       "-y",
                                       "-f",
                                       "rawvideo",
                                       "-pix_fmt",
                                       "rgb24",
                                       "-video_size",
                                       fmt::format("{}x{}", width_px, height_px),
                                       "-framerate",
                                       std::to_string(film_frames_per_s),
                                       "-i",
                                       "-",
                                       "-pix_fmt",
                                       "yuv420p",
                                       "-movflags",
                                       "+faststart",
                                       "-f",
                                       "mp4",
                                       "file:" + file_.open_name()};
  int pictures = -1;
  std::optional<ChildProcess> process = ChildProcess::fork(ChildProcess::Pipe::to_child, pictures);
  if (!process) {
    keep_open(file_.descriptor());
    run_program(words, pictures);
  }
  ffmpeg_.emplace(std::move(*process));
}

void Film::add(std::span<const std::uint8_t> rgb) {
  const std::string_view bytes(reinterpret_cast<const char*>(rgb.data()), rgb.size());
  if (!ffmpeg_->write(bytes)) throw OutputError(fmt::format("{}: ffmpeg has ended", name_));
}

void Film::finish() {
  const ChildProcess::Ending ending = ffmpeg_->wait();
  ffmpeg_.reset();
  if (!ending.is_success()) {
    throw OutputError(fmt::format("{}: cannot be made: ffmpeg's code {}", name_,
                                  ending.code.value_or(128 + *ending.signal)));
  }
  file_.replace();
}

}  // namespace lsos
