#include "rovers/figures.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "base/units.h"
#include "mission/model/site.h"
#include "mission/routes/drive_cost_model.h"
#include "mission/routes/follower_limits.h"
#include "physics/drive.h"
#include "vehicle/follower_pose.h"

namespace lsos::rovers {

const std::vector<Subject> subjects = {{"SEV", "Moon", "ApolloNominal", "Craters"},
                                       {"LRV", "Moon", "ApolloNominal", "Craters"},
                                       {"ATHLETE", "Moon", "ApolloNominal", "Craters"},
                                       {"VIPER", "Moon", "ApolloNominal", "Craters"},
                                       {"Rashid", "Moon", "ApolloNominal", "Craters"},
                                       {"MSL", "Mars", "MMS", "Craters"},
                                       {"MER", "Mars", "MMS", "Craters"},
                                       {"Husky", "Earth", "DrySand", "Flat"}};

namespace {

constexpr double least_share = 0.1;  // of the cruise speed, uphill: below it, the slope stops it
constexpr double across_off_m = 1;   // farther off its line, it slides down a slope
constexpr double rest_s = 2;
constexpr int steepest_deg = 45;

std::unique_ptr<Ground> plane(const Subject& subject, double slope_rad) {
  return test::ground({subject.planet, PlaneSurface{0, slope_rad, radians(180)}, subject.soil});
}

void advance(Vehicle& vehicle, double time_s) {
  for (double t = 0; t < time_s; t += seconds(exchange_period)) vehicle.advance(exchange_period);
}

// The steepest whole degree at which something holds, if it holds at all less steep ones.
template <class Holds>
double steepest_rad(const Holds& holds) {
  int low = 0, high = steepest_deg + 1;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (holds(radians(middle)) ? low : high) = middle;
  }
  return radians(low);
}

bool climbs(const Subject& subject, double slope_rad) {
  const auto slope = plane(subject, slope_rad);
  const VehicleConfig config = test::rover_on(subject.rover, *slope, subject.planet);
  Vehicle vehicle(config, *slope);
  if (!vehicle.place(slope->site().origin(), 0).empty()) return false;
  vehicle.command({.speed_mps = config.cruise_speed_mps, .is_braking = false});
  advance(vehicle, 60 + 2 / config.cruise_speed_mps);
  const VehicleReport report = vehicle.report();
  return report.is_finite &&
         report.v_S_mps.y() / std::cos(slope_rad) > least_share * config.cruise_speed_mps;
}

bool drives_across(const Subject& subject, double slope_rad) {
  constexpr double length_m = 10;
  const auto slope = plane(subject, slope_rad);
  const VehicleConfig config = test::rover_on(subject.rover, *slope, subject.planet);
  const test::DriveResult result =
      test::drive(config, *slope, {{length_m, 0}}, config.cruise_speed_mps);
  return result.failure.empty() && result.worst_m < across_off_m;
}

double level_jpm(const Subject& subject) {
  constexpr double near_m = 10, far_m = 30;
  const auto level = plane(subject, 0);
  const VehicleConfig config = test::rover_on(subject.rover, *level, subject.planet);
  const auto go = [&](double length_m) {
    return test::drive(config, *level, {{0, length_m}}, config.cruise_speed_mps);
  };
  // The difference of two drives is without starting and stopping.
  const test::DriveResult near = go(near_m), far = go(far_m);
  return (far.drive_j - near.drive_j) / (far.distance_m - near.distance_m);
}

// The circle of its tightest turn, from what it drives while it turns by half a circle.
double turning_radius_m(const Subject& subject) {
  const auto level = plane(subject, 0);
  const VehicleConfig config = test::rover_on(subject.rover, *level, subject.planet);
  Vehicle vehicle(config, *level);
  vehicle.place(level->site().origin(), 0);
  const double speed_mps = config.cruise_speed_mps / 2;
  vehicle.command({.speed_mps = speed_mps,
                   .yaw_rate_radps = speed_mps / config.turning_radius_min_m,
                   .is_braking = false});
  advance(vehicle, 5 + 1 / config.acceleration_mps2);
  const double from_m = vehicle.distance_m();
  double turned_rad = 0, before_rad = vehicle.report().yaw_rad;
  while (turned_rad < std::numbers::pi && vehicle.distance_m() - from_m < 200) {
    vehicle.advance(exchange_period);
    const double now_rad = vehicle.report().yaw_rad;
    turned_rad += std::remainder(now_rad - before_rad, 2 * std::numbers::pi);
    before_rad = now_rad;
  }
  return (vehicle.distance_m() - from_m) / turned_rad;
}

Crossing cross_the_pole(const Subject& subject) {
  constexpr double length_m = 200;
  const Geodetic from{radians(30), radians(-89.3), 0};
  const double heading_rad = radians(60);
  const Body& moon = *find_body("Moon");
  const auto ground = ground_at(test::shipped_terrain("LunarSouthPole"), moon, from, 7);
  const VehicleConfig config = test::rover_on(subject.rover, *ground, "Moon");
  Crossing crossing;
  Vehicle vehicle(config, *ground);
  crossing.failure = vehicle.place(from, heading_rad);
  if (!crossing.failure.empty()) return crossing;
  const SiteFrame& site = ground->site();
  VehicleReport report = vehicle.report();
  const FollowerLimits limits =
      limits_of(config, config.cruise_speed_mps, site.gravity_S_mps2(Vec3::Zero()).norm());
  PathFollower follower({report.p_S_m + length_m * site.horizontal_S(heading_rad, report.p_S_m)},
                        follower_pose(report), limits);
  while (follower.status() == PathFollower::Status::driving) {
    vehicle.command(follower.update(follower_pose(report), seconds(exchange_period)));
    vehicle.advance(exchange_period);
    report = vehicle.report();
    if (!report.is_finite) break;
    crossing.slope_max_rad = std::max(crossing.slope_max_rad, report.slope_rad);
    crossing.tilt_max_rad = std::max(
        crossing.tilt_max_rad, std::acos(std::cos(report.pitch_rad) * std::cos(report.roll_rad)));
  }
  crossing.failure = report.is_finite ? follower.reason() : vehicle.fault();
  crossing.distance_m = vehicle.distance_m();
  crossing.energy_jpm = vehicle.drive_j() / vehicle.distance_m();
  return crossing;
}

}  // namespace

Figures measure(const Subject& subject) {
  Figures figures;
  const auto level = plane(subject, 0);
  const VehicleConfig config = test::rover_on(subject.rover, *level, subject.planet);
  figures.mass_kg = config.mass_kg();
  Vehicle vehicle(config, *level);
  vehicle.place(level->site().origin(), 0);
  advance(vehicle, rest_s);
  std::vector<double> loads_n;
  const auto wheels = static_cast<std::size_t>(
      std::ranges::count_if(config.links, [](const LinkConfig& link) { return !!link.wheel; }));
  for (std::size_t i = 0; i < wheels; ++i) loads_n.push_back(vehicle.wheel_load_n(i));
  figures.load_least_n = std::ranges::min(loads_n);
  figures.load_greatest_n = std::ranges::max(loads_n);
  for (const double load_n : loads_n) figures.load_mean_n += load_n / static_cast<double>(wheels);

  figures.climb_rad = steepest_rad([&](double slope) { return climbs(subject, slope); });
  figures.side_rad = steepest_rad([&](double slope) { return drives_across(subject, slope); });
  figures.level_jpm = level_jpm(subject);
  if (config.can_turn_on_spot) {
    figures.turn_rate_radps = turn_rate_radps(config);
  } else {
    figures.turning_radius_m = turning_radius_m(subject);
  }
  figures.crossing = cross_the_pole(subject);
  return figures;
}

double times_real_time(const Subject& subject) {
  constexpr double simulated_s = 300;
  const auto level = plane(subject, 0);
  const VehicleConfig config = test::rover_on(subject.rover, *level, subject.planet);
  Vehicle vehicle(config, *level);
  vehicle.place(level->site().origin(), 0);
  vehicle.command({.speed_mps = config.cruise_speed_mps, .is_braking = false});
  const auto begin = std::chrono::steady_clock::now();
  advance(vehicle, simulated_s);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return simulated_s / elapsed.count();
}

}  // namespace lsos::rovers
