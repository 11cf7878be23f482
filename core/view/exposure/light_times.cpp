#include "view/exposure/light_times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "planet/sunlight.h"
#include "view/exposure/disc_strips.h"
#include "view/ground/highest_ground.h"
#include "view/ground/horizon_reach.h"

namespace lsos {

std::vector<SunMoment> sun_moments(Instant from, Instant to, SimTime every) {
  std::vector<SunMoment> moments;
  for (Instant at = from; at < to; at = at + every) {
    moments.push_back({at, seconds(std::min(every, to - at))});
  }
  return moments;
}

// The horizon around one place, as far as it has been looked at.
struct LightTimesProbe::Horizon {
  HorizonMarch::Eye eye;
  Vec3 north_S, east_S;
  double lowest_rad = 0, highest_rad = 0;  // of any part of the disc above the lowest horizon
  double matters_m = 0;
  std::array<std::optional<HorizonPoint>, azimuths> points{};
};

LightTimesProbe::LightTimesProbe(const Ground& ground, double resolution_m,
                                 std::vector<SunMoment> moments)
    : ground_(&ground), march_(ground, resolution_m), moments_(std::move(moments)) {}

const HorizonPoint& LightTimesProbe::horizon(Horizon& around, int azimuth) {
  const int wrapped = (azimuth % azimuths + azimuths) % azimuths;
  auto& point = around.points[static_cast<std::size_t>(wrapped)];
  if (!point) {
    const double azimuth_rad = 2 * std::numbers::pi * wrapped / azimuths;
    const Vec3 along_S =
        std::cos(azimuth_rad) * around.north_S + std::sin(azimuth_rad) * around.east_S;
    point = march_.towards(around.eye, along_S, around.lowest_rad, around.highest_rad,
                           around.matters_m);
  }
  return *point;
}

// Share of the disc that stands above the horizon; notes in `times` where that is over the end of
// the ground.
double LightTimesProbe::fraction(Horizon& around, double azimuth_rad, double sun_rad,
                                 double disc_rad, LightTimes& times) {
  double fraction = 0;
  for (const DiscStrip& strip : disc_strips(sun_rad, disc_rad)) {
    const double steps = (azimuth_rad + strip.azimuth_rad) / (2 * std::numbers::pi) * azimuths;
    const double below = std::floor(steps);
    const HorizonPoint& left = horizon(around, static_cast<int>(below));
    const HorizonPoint& right = horizon(around, static_cast<int>(below) + 1);
    const double horizon_rad = std::lerp(left.elevation_rad, right.elevation_rad, steps - below);
    const double seen = seen_share(strip, sun_rad, horizon_rad);
    if (seen <= 0) continue;
    fraction += seen / disc_strips_count;
    const double reaches_m =
        std::min(left.end_m.value_or(std::numeric_limits<double>::infinity()),
                 right.end_m.value_or(std::numeric_limits<double>::infinity()));
    const Body& body = ground_->site().body();
    const double matters_m = horizon_reach_m(body, around.eye.height_m, sun_rad - disc_rad);
    if (reaches_m >= matters_m || (times.end && times.end->reaches_m <= reaches_m)) continue;
    times.end = GroundEnd{reaches_m, matters_m};
    times.end_sun_rad = sun_rad;
  }
  return fraction;
}

std::optional<LightTimes> LightTimesProbe::at(const Geodetic& place) {
  const auto eye = march_.eye(place, 0);
  if (!eye) return {};
  const SiteFrame& site = ground_->site();
  const double dip_rad = horizon_dip_rad(site.body(), eye->height_m);
  std::vector<Sunlight> suns;
  double lowest_rad = std::numbers::pi / 2, highest_rad = -dip_rad;
  for (const SunMoment& moment : moments_) {
    const Sunlight& sun = suns.emplace_back(sunlight(site.body(), place, moment.at, 0));
    lowest_rad = std::min(lowest_rad, sun.seen.elevation_rad - sun.disc_rad);
    highest_rad = std::max(highest_rad, sun.seen.elevation_rad + sun.disc_rad);
  }
  Horizon around{*eye,
                 site.north_S(eye->p_S_m),
                 site.east_S(eye->p_S_m),
                 std::max(lowest_rad, -dip_rad),
                 highest_rad,
                 0,
                 {}};
  if (ground_->has_end()) {
    around.matters_m = horizon_reach_m(site.body(), eye->height_m, around.lowest_rad);
  }
  LightTimes times;
  double all_s = 0, dark_s = 0, lit_s = 0;
  for (std::size_t k = 0; k < moments_.size(); ++k) {
    const Sunlight& sun = suns[k];
    const double sun_rad = sun.seen.elevation_rad, lasts_s = moments_[k].lasts_s;
    double share = 0;
    if (sun_rad + sun.disc_rad > -dip_rad && sun.eclipsed < 1) {
      share =
          fraction(around, sun.seen.azimuth_rad, sun_rad, sun.disc_rad, times) * (1 - sun.eclipsed);
    }
    all_s += lasts_s;
    times.mean_fraction += share * lasts_s;
    dark_s = share > 0 ? 0 : dark_s + lasts_s;
    lit_s = share > 0 ? lit_s + lasts_s : 0;
    times.longest_dark_s = std::max(times.longest_dark_s, dark_s);
    times.longest_lit_s = std::max(times.longest_lit_s, lit_s);
  }
  times.mean_fraction /= all_s;
  return times;
}

}  // namespace lsos
