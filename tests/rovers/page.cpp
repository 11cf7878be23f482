#include "rovers/page.h"

#include <fmt/format.h>

#include "base/units.h"

namespace lsos::rovers {

namespace {

constexpr double j_per_wh = 3600;

std::string wh_pkm(double jpm) { return fmt::format("{:.3g}", jpm * 1000 / j_per_wh); }

std::string slope(double slope_rad) { return fmt::format("{:.0f}", degrees(slope_rad)); }

std::string turn(const Figures& f) {
  if (f.turning_radius_m) return fmt::format("{:.1f} m", *f.turning_radius_m);
  return fmt::format("on the spot, {:.1f} deg/s", degrees(f.turn_rate_radps));
}

std::string crossing(const Crossing& c) {
  if (!c.failure.empty()) {
    return fmt::format("ends after {:.0f} m: {} | | |", c.distance_m, c.failure);
  }
  return fmt::format("{} | {:.0f} | {:.0f} |", wh_pkm(c.energy_jpm), degrees(c.slope_max_rad),
                     degrees(c.tilt_max_rad));
}

}  // namespace

std::string picture_path(const Subject& subject) {
  return fmt::format("rovers/pictures/{}.png", subject.rover);
}

std::string page(const std::vector<Figures>& figures) {
  std::string text =
      "# Rovers, measured\n\n"
      "Written by the program `write_rovers` (`cmake --preset dev && cmake --build build/dev "
      "--target write_rovers && build/dev/bin/write_rovers`), which drives each shipped rover; do "
      "not edit it. What the numbers rest on, and what of it is assumed, says each rover's "
      "script.\n"
      "\n| | | |\n|---|---|---|\n";
  constexpr std::size_t columns = 3;
  for (std::size_t i = 0; i < subjects.size(); i += columns) {
    std::string names = "|";
    text += "|";
    for (std::size_t k = i; k < i + columns; ++k) {
      const bool is_one = k < subjects.size();
      text += is_one ? fmt::format(" ![{0}](pictures/{0}.png) |", subjects[k].rover) : " |";
      names += is_one ? fmt::format(" {} |", subjects[k].rover) : " |";
    }
    text += "\n" + names + "\n";
  }

  text +=
      "\n## At home\n\n"
      "On a plane of one soil, at the rover's cruise speed. Loads are those of the wheels at rest "
      "on "
      "the level: least, mean, greatest. It climbs a slope if it drives up from rest at more than "
      "a "
      "tenth of its speed, and drives across one if it stays within 1 m of a line of 10 m; slopes "
      "in "
      "whole degrees, at most 45. Energy is what its motors draw, without other loads, starting "
      "and stopping.\n\n"
      "| rover | where | mass, kg | wheel loads, N | climbs, deg | across, deg | Wh/km on the "
      "level | "
      "turns |\n|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const Figures& f = figures[i];
    text += fmt::format("| {} | {}, {} | {:.0f} | {:.3g}, {:.3g}, {:.3g} | {} | {} | {} | {} |\n",
                        subjects[i].rover, subjects[i].planet, subjects[i].soil, f.mass_kg,
                        f.load_least_n, f.load_mean_n, f.load_greatest_n, slope(f.climb_rad),
                        slope(f.side_rad), wh_pkm(f.level_jpm), turn(f));
  }

  text +=
      "\n## Over LunarSouthPole\n\n"
      "200 m straight from 30, -89.3 towards 60 degrees from north, Seed 7, in the Moon's gravity, "
      "at "
      "cruise speed, without looking for a better way.\n\n"
      "| rover | Wh/km | steepest under its wheels, deg | greatest tilt, deg |\n"
      "|---|---|---|---|\n";
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    text += fmt::format("| {} | {}\n", subjects[i].rover, crossing(figures[i].crossing));
  }
  return text + "\n";
}

std::string speed_part(const std::string& machine, const std::vector<double>& times) {
  std::string text = speed_heading;
  text += fmt::format(
      "\nTimes real time on one core of a {}: dynamics on the level, without light, sight and "
      "log.\n\n"
      "| rover | times real time |\n|---|---|\n",
      machine);
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    text += fmt::format("| {} | {:.0f} |\n", subjects[i].rover, times[i]);
  }
  return text;
}

}  // namespace lsos::rovers
