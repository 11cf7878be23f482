// `lsos-host picture`: pictures and films of a rover of a run, as the Sun or a camera saw it.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/output_file.h"
#include "base/rounding.h"
#include "base/stop_signal.h"
#include "lua/app/commands.h"
#include "lua/app/common_options.h"
#include "lua/app/instrument_answer.h"
#include "lua/app/opened_run.h"
#include "picture/film.h"
#include "picture/picture_frame.h"
#include "picture/png.h"

namespace lsos {

namespace {

struct PictureOptions {
  std::string folder;  // of a run
  std::string at;      // UTC, or a time from the start; "": of a film
  std::string from;    // "": chase for a film, else sun
  std::string rover;   // "": the first
  std::string file;    // X.png, X.mp4
  int size_px = 0;     // 0: as the view has it
  bool is_movie = false;
  std::string every;  // of a film, "": some 250 pictures
  bool is_quiet = false;
  AnswerStyle style = AnswerStyle::by_output;
};

void check_picture(const PictureOptions& options) {
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

void print_about(const PictureOptions& options, const AnswerRow& about) {
  AnswerRow answer{{"file", options.file}};
  answer.update(about);
  print_answer(AnswerRow::array({answer}), options.style);
}

int make_film(const PictureOptions& options, const PictureRun& run, const PictureRequest& request,
              const Gpu& gpu, Lettering& letters) {
  const PictureSize size = picture_size(run, request);
  AnswerRow about;
  catch_stop_signals();
  Film film(options.file, size.width_px, size.height_px);
  for (std::size_t k = 0; k < run.times.size(); ++k) {
    const PictureFrameOut frame = picture_of(run, k, request, gpu, letters);
    if (k == 0) about = frame.about;
    film.add(frame.picture.rgb);
    if (stop_signal() != 0) return 128 + stop_signal();
    if (!options.is_quiet && isatty(STDERR_FILENO) != 0) {
      redraw_message(fmt::format("picture {} of {}", k + 1, run.times.size()));
      if (k + 1 == run.times.size()) print_message("\n");
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
  print_about(options, about);
  return 0;
}

int picture_command(const PictureOptions& options) {
  check_picture(options);
  Faults faults;
  check_output("-o", options.file, {options.is_movie ? ".mp4" : ".png"}, {}, faults);
  faults.throw_if_errors();
  const PictureRun run = options.is_movie ? open_film(options.folder, options.every, options.rover)
                                          : open_picture(options.folder, options.at);
  for (const std::string& warning : run.warnings) print_message("warning: {}\n", warning);
  const std::string from = !options.from.empty() ? options.from
                           : options.is_movie    ? "chase"
                                                 : "sun";
  const PictureRequest request{from, options.rover, options.size_px};
  const Gpu gpu;
  Lettering letters;
  if (options.is_movie) return make_film(options, run, request, gpu, letters);
  const PictureFrameOut out = picture_of(run, 0, request, gpu, letters);
  write_png(options.file, out.picture.width_px, out.picture.height_px, out.picture.rgb);
  print_about(options, out.about);
  return 0;
}

}  // namespace

std::function<int()> prepare_picture(CommandOptions& command) {
  const auto options = std::make_shared<PictureOptions>();
  command.add_option("DIR", options->folder, "Folder of a run").required();
  command.add_option("--at", options->at, "UTC, or a time from the start: 90, 2 h");
  command.add_option("--from", options->from,
                     "sun (its panels green), chase, east, above, or the RoverId of one that sees "
                     "it (sun; of a film chase)");
  command.add_option("--rover", options->rover, "RoverId (the first)");
  command.add_option("--size", options->size_px, "Width, pixels (1280; from sun 800)")
      .between(64, 4096);
  command.add_flag("--movie", options->is_movie, "A film of all the run, in place of --at");
  command.add_option("--every", options->every,
                     "Of the mission, from one of its pictures to the next (for some 250, four "
                     "in five of them while the rover drives)");
  command.add_option("-o,--output", options->file, "The PNG, or MP4, to write").required();
  command.add_flag("--quiet", options->is_quiet, "No progress");
  add_style(command, options->style);
  return [options] { return picture_command(*options); };
}

}  // namespace lsos
