// A finished or killed run, opened with the mission that it was made of.
#pragma once

#include <string>

#include "picture/picture_run.h"
#include "record/log.h"

namespace lsos {

// Throw InputError: no such run, or no such time in it.
PictureRun open_picture(const std::string& folder, const std::string& at);
// `every`: "" for some 250 pictures, most of them while `rover` ("" for the first) drives.
PictureRun open_film(const std::string& folder, const std::string& every, const std::string& rover);
// The same without any moments yet.
PictureRun open_run(const std::string& folder, const LogReader& log);

// A run with as much of its mission as can still be read.
struct LoggedMission {
  PictureRun run;
  std::vector<std::string> left_out;  // what is missing or not as it was, and why
};
// Files that the plan had beside it (scripts, rasters) may have been moved since; the run is then
// opened without its ground.
LoggedMission open_run_or_log(const std::string& folder, const LogReader& log);
// For pages that draw the ground of another run.
LoggedMission open_without_ground(const std::string& folder, const LogReader& log);

}  // namespace lsos
