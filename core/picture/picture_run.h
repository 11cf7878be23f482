// A finished or killed run, opened to make pictures of it; or one in hand.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mission/model/mission_model.h"
#include "picture/film_times.h"
#include "picture/logged_run.h"
#include "planet/sunlight.h"
#include "terrain/ground.h"

namespace lsos {

struct PictureRun {
  MissionModel files;
  std::shared_ptr<const Ground> ground;
  Instant start;
  SimTime end{};
  std::vector<SimTime> times;  // of the pictures
  std::vector<FilmTime> film;  // the same of a film, else empty
  LoggedRun logged;            // then
  std::vector<std::string> rovers;
  std::vector<std::string> warnings;
};

// `times` ascend.
void read_moments(PictureRun& run, const LogReader& log, const std::vector<SimTime>& times);
// "10 min", or UTC, of `option`. Throws InputError.
SimTime time_since_start(const std::string& option, const std::string& text, Instant start);

// One moment, and how the Sun shone on one of its rovers.
struct PictureMoment {
  const LoggedMoment* rovers = nullptr;
  const LoggedRover* rover = nullptr;
  Instant utc;
  Sunlight sun;
  Vec3 sun_S = Vec3::UnitZ();
  std::optional<FilmTime> film;
};
// `k`: of the run's times. `rover`: "" for the first. Throws InputError: none of that name until
// then.
PictureMoment moment(const PictureRun& run, std::size_t k, const std::string& rover);

}  // namespace lsos
