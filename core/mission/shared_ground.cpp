#include "mission/shared_ground.h"

#include <chrono>
#include <vector>

#include "planet/sunlight.h"
#include "view/exposure/sun_column.h"

namespace lsos {

namespace {

// Distance between places along a way, and to either side of it, where wheels roll; and between
// those from which the horizon is looked at.
constexpr double along_m = 2, aside_m = 2.5, look_m = 100;
// Radius about a rover that light is evaluated for.
constexpr double rover_m = 5;

// Ways of all rovers: those planned, and straight lines between the places of events.
std::vector<Path3> ways_of(const Simulation& prepared) {
  const SiteFrame& site = prepared.ground().site();
  std::vector<Path3> ways;
  for (const RoverRoutesAhead& rover : prepared.routes_ahead()) {
    for (const LegAhead& leg : rover.legs) ways.push_back(leg.leg.path_S_m);
  }
  for (const PlanRover& rover : prepared.plan().rovers) {
    Path3 way{site.p_S_m(rover.start)};
    for (const PlanEvent& event : prepared.plan().events) {
      if (event.rover_id != rover.id || !event.is_enabled) continue;
      for (const Geodetic& point : event.geometry.points) way.push_back(site.p_S_m(point));
    }
    ways.push_back(way);
  }
  return ways;
}

class SharedWays {
 public:
  SharedWays(const Simulation& prepared, double longest_s)
      : ground_(prepared.ground()),
        probe_(prepared.ground()),
        start_(prepared.plan().mission.start_time),
        until_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                  std::chrono::duration<double>(longest_s))) {}

  // Returns false when the time is over.
  bool sample(const Path3& way_S_m) {
    double left_m = 0, look_left_m = 0;
    for (std::size_t k = 1; k < way_S_m.size(); ++k) {
      const Vec3 piece_m = way_S_m[k] - way_S_m[k - 1];
      const double length_m = piece_m.norm();
      const Vec3 ahead = length_m > 0 ? Vec3(piece_m / length_m) : Vec3::UnitX();
      for (; left_m <= length_m; left_m += along_m, look_left_m -= along_m) {
        if (Clock::now() > until_) return false;
        const Vec3 at_S_m = way_S_m[k - 1] + left_m * ahead;
        const Vec3 left = ground_.site().up_S(at_S_m).cross(ahead);
        for (const double side_m : {-aside_m, 0.0, aside_m}) {
          probe_.sample(at_S_m + side_m * left);
          ++count_;
        }
        if (look_left_m <= 0) {
          look_at_sun(at_S_m);
          look_left_m = look_m;
        }
      }
      left_m -= length_m;
    }
    return true;
  }
  int count() const { return count_; }

 private:
  using Clock = std::chrono::steady_clock;

  void look_at_sun(const Vec3& at_S_m) {
    const SiteFrame& site = ground_.site();
    Geodetic place = site.geodetic(at_S_m);
    const auto elevation_m = ground_.elevation_m(place);
    if (!elevation_m) return;
    place.height_m = *elevation_m + rover_m;
    const Vec3 eye_S_m = site.p_S_m(place);
    const Sunlight light = sunlight(site.body(), place, start_, 0);
    if (light.irradiance_wpm2 <= 0) return;
    ground_mesh(ground_, sun_column(eye_S_m, rover_m, direction_S(site, eye_S_m, light.seen),
                                    light.disc_rad));
  }

  const Ground& ground_;
  Ground::Probe probe_;
  Instant start_;
  Clock::time_point until_;
  int count_ = 0;
};

}  // namespace

int share_ground(const Simulation& prepared, double longest_s) {
  if (!prepared.ground().share_layers()) return 0;
  SharedWays shared(prepared, longest_s);
  for (const Path3& way_S_m : ways_of(prepared)) {
    if (!shared.sample(way_S_m)) break;
  }
  return shared.count();
}

}  // namespace lsos
