// What a shipped rover does when it is driven: loads, slopes, energy, turns.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lsos::rovers {

// A shipped rover, where it is at home, and a place there for its picture.
struct Subject {
  const char *rover, *planet, *soil, *terrain;
};
extern const std::vector<Subject> subjects;

// A drive over craters of LunarSouthPole.
struct Crossing {
  std::string failure;  // why it ended early, "" when it arrived
  double distance_m = 0;
  double energy_jpm = 0;  // electrical, of the motors
  double slope_max_rad = 0, tilt_max_rad = 0;
};

struct Figures {
  double mass_kg = 0;
  double load_least_n = 0, load_mean_n = 0, load_greatest_n = 0;  // on wheels, at rest on the level
  double climb_rad = 0;                    // steepest slope that it drives up from rest
  double side_rad = 0;                     // steepest slope across which it drives
  double level_jpm = 0;                    // energy of the motors at cruise speed on the level
  std::optional<double> turning_radius_m;  // absent: it turns on the spot
  double turn_rate_radps = 0;              // on the spot
  Crossing crossing;
};

Figures measure(const Subject& subject);

// Simulated over elapsed time of a drive on the level, on this machine, without light and sight.
double times_real_time(const Subject& subject);

}  // namespace lsos::rovers
