// A finished or killed run, or an interactive simulation, opened to draw pictures of it.
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
  std::vector<SimTime> times;  // times of the pictures
  std::vector<FilmTime> film;  // times and rates of a film, else empty
  LoggedRun logged;            // the rovers at these times
  std::vector<std::string> rovers;
  std::vector<std::string> warnings;
};

// `times` ascend.
void read_moments(PictureRun& run, const LogReader& log, const std::vector<SimTime>& times);
// Value of `option`, given as "10 min" or UTC. Throws InputError.
SimTime time_since_start(const std::string& option, const std::string& text, Instant start);

// One time of a run, and the sunlight on one of its rovers.
struct PictureMoment {
  const LoggedMoment* rovers = nullptr;
  const LoggedRover* rover = nullptr;
  Instant utc;
  Sunlight sun;
  Vec3 sun_S = Vec3::UnitZ();
  std::optional<FilmTime> film;
};
// `k`: index into the run's times. `rover`: "" for the first. Throws InputError where no rover of
// that name has a sample by then.
PictureMoment moment(const PictureRun& run, std::size_t k, const std::string& rover);

}  // namespace lsos
