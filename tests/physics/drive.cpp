#include "physics/drive.h"

#include <algorithm>
#include <cmath>

#include "base/segment.h"
#include "lua/host/mission_reader.h"
#include "mission/model/site.h"
#include "mission/routes/follower_limits.h"
#include "planet/ellipsoid.h"
#include "vehicle/follower_pose.h"

namespace lsos::test {

namespace {

const Catalog& catalog() {
  static const auto shipped = read_catalog("");
  return *shipped;
}

double distance_to_line_m(const Vec2& p, const std::vector<Vec2>& line) {
  double nearest_m = 1e9;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    nearest_m = std::min(nearest_m, point_distance_m(line[i], line[i + 1], p));
  }
  return nearest_m;
}

}  // namespace

Soil shipped_soil(const std::string& name) { return catalog().load_soil(name); }
TerrainSpec shipped_terrain(const std::string& name) { return catalog().load_terrain(name); }
RoverSpec shipped_rover(const std::string& name) { return catalog().load_rover(name).spec; }

std::unique_ptr<Ground> ground(const GroundAt& at) {
  TerrainSpec spec;
  spec.name = "Test";
  spec.layers = {at.surface};
  spec.detail = at.detail;
  spec.soil = shipped_soil(at.soil);
  return ground_at(spec, *find_body(at.planet), start, 1);
}

VehicleConfig rover_on(const std::string& name, const Ground& ground, const std::string& planet,
                       const std::string& configuration, double step_share) {
  VehicleConfig config = make_vehicle(shipped_rover(name), configuration,
                                      gravity_mps2(*find_body(planet), ground.site().origin()));
  config.step = from_seconds(step_share * seconds(config.step));
  return config;
}

DriveResult drive(const VehicleConfig& config, const Ground& ground,
                  const std::vector<Vec2>& waypoints_S_m, double speed_mps) {
  DriveResult result;
  Vehicle vehicle(config, ground);
  const Vec2& first = waypoints_S_m.front();
  result.failure = vehicle.place(ground.site().origin(), std::atan2(first.x(), first.y()));
  if (!result.failure.empty()) return result;
  const double before_j = vehicle.kinetic_j() + vehicle.potential_j();

  Path3 path;
  std::vector<Vec2> line{Vec2::Zero()};
  for (const Vec2& p : waypoints_S_m) {
    path.push_back({p.x(), p.y(), 0});
    line.push_back(p);
  }
  const FollowerLimits limits =
      limits_of(config, speed_mps, ground.site().gravity_S_mps2(Vec3::Zero()).norm());
  PathFollower follower(path, follower_pose(vehicle.report()), limits);
  VehicleReport report = vehicle.report();
  while (follower.status() == PathFollower::Status::driving) {
    vehicle.command(follower.update(follower_pose(report), seconds(exchange_period)));
    vehicle.advance(exchange_period);
    report = vehicle.report();
    result.duration_s += seconds(exchange_period);
    result.worst_m = std::max(result.worst_m, distance_to_line_m(report.p_S_m.head<2>(), line));
  }
  result.failure = follower.reason();
  result.end = report;
  result.distance_m = vehicle.distance_m();
  result.drive_j = vehicle.drive_j();
  result.work = vehicle.work();
  result.energy_change_j = vehicle.kinetic_j() + vehicle.potential_j() - before_j;
  return result;
}

}  // namespace lsos::test
