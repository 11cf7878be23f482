// `lsos-host picture`: a rover of a run, as the Sun or a camera saw it, and films of that.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>

#include "lua/commands.h"
#include "lua/console.h"
#include "lua/instrument_answer.h"
#include "lua/output_file.h"
#include "lua/picture_frame.h"
#include "product/film.h"
#include "product/png.h"

namespace lsos {

namespace {

std::atomic<int> asked_to_stop{0};

void ask_to_stop(int signal) { asked_to_stop = signal; }

void check(const PictureOptions& options) {
  if (!options.is_movie && options.file.ends_with(".mp4")) {
    throw InputError({}, fmt::format("-o {}: a film is made with --movie", options.file));
  }
  if (!options.is_movie) {
    if (options.at.empty()) {
      throw InputError({}, "--at is missing: UTC or a time from the start, as 10 min; or --movie");
    }
    if (!options.every.empty()) {
      throw InputError({}, fmt::format("--every {}: only with --movie", options.every));
    }
    return;
  }
  if (!options.at.empty()) {
    throw InputError({}, fmt::format("--at {}: a --movie shows all of a run", options.at));
  }
  if (options.size_px % 2 != 0) {
    throw InputError({}, fmt::format("--size {}: a --movie's must be even", options.size_px));
  }
}

void print(const PictureOptions& options, const AnswerRow& about) {
  AnswerRow answer{{"file", options.file}};
  answer.update(about);
  print_answer(AnswerRow::array({answer}), options.style);
}

int make_film(const PictureOptions& options, const PictureRun& run, const PictureWish& wish,
              const Gpu& gpu, Lettering& letters) {
  const PictureSize size = picture_size(run, wish);
  AnswerRow about;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  Film film(options.file, size.width_px, size.height_px);
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    const PictureFrameOut frame = picture_of(run, k, wish, gpu, letters);
    if (k == 0) about = frame.about;
    film.add(frame.picture.rgb);
    if (asked_to_stop != 0) return 128 + asked_to_stop;
    if (!options.is_quiet && isatty(STDERR_FILENO) != 0) {
      print_message("\rpicture {} of {}{}", k + 1, run.times.size(),
                    k + 1 == run.times.size() ? "\n" : "");
    }
  }
  film.finish();
  about["pictures"] = run.times.size();
  const auto rate = [&](bool is_quiet) {
    const auto found = std::ranges::find(run.film, is_quiet, &FilmTime::is_quiet);
    return found == run.film.end() ? AnswerRow() : AnswerRow(computed(found->rate));
  };
  about["times_real_time"] = rate(false);
  about["times_real_time_while_standing"] = rate(true);
  print(options, about);
  return 0;
}

}  // namespace

int picture_command(const PictureOptions& options) {
  check(options);
  Faults faults;
  check_output("-o", options.file, {options.is_movie ? ".mp4" : ".png"}, {}, faults);
  faults.throw_if_errors();
  const PictureRun run = options.is_movie ? open_film(options.folder, options.every, options.rover)
                                          : open_picture(options.folder, options.at);
  for (const std::string& warning : run.warnings) print_message("warning: {}\n", warning);
  const std::string from = !options.from.empty() ? options.from
                           : options.is_movie    ? "chase"
                                                 : "sun";
  const PictureWish wish{from, options.rover, options.size_px};
  const Gpu gpu;
  Lettering letters;
  if (options.is_movie) return make_film(options, run, wish, gpu, letters);
  const PictureFrameOut out = picture_of(run, 0, wish, gpu, letters);
  write_png(options.file, out.picture.width_px, out.picture.height_px, out.picture.rgb);
  print(options, out.about);
  return 0;
}

}  // namespace lsos
