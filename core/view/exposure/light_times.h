// Light on the ground over a span of time: how much of it a place sees the Sun, and for how long on
// end it does not.
#pragma once

#include <optional>
#include <vector>

#include "planet/utc.h"
#include "view/ground/horizon_march.h"

namespace lsos {

// A moment at which the Sun is looked at; it stands for the time up to the next.
struct SunMoment {
  Instant at;
  double lasts_s = 0;
};

// From `from`, each `every` up to `to`, which is not one of them; the last lasts as long as is
// left. `every` above 0, `from` before `to`.
std::vector<SunMoment> sun_moments(Instant from, Instant to, SimTime every);

struct LightTimes {
  double mean_fraction = 0;   // of the disc that is seen, 0..1, over all the time
  double longest_dark_s = 0;  // without any part of the disc
  double longest_lit_s = 0;   // with some part of it
  // Present where the disc is seen over the end of the known ground at some moment: the nearest
  // end, and the Sun's elevation then.
  std::optional<GroundEnd> end;
  double end_sun_rad = 0;
};

// The horizon around each place is marched once in each quarter of a degree of azimuth that the Sun
// crosses, and is linear between them, however many the moments. Use one per thread; results do not
// depend on earlier calls.
class LightTimesProbe {
 public:
  // `resolution_m`: as of GroundLightProbe.
  LightTimesProbe(const Ground& ground, double resolution_m, std::vector<SunMoment> moments);

  // Absent where there is no ground.
  std::optional<LightTimes> at(const Geodetic& place);

 private:
  static constexpr int azimuths = 1440;

  struct Horizon;
  const HorizonPoint& horizon(Horizon& around, int azimuth);
  double fraction(Horizon& around, double azimuth_rad, double sun_rad, double disc_rad,
                  LightTimes& times);

  const Ground* ground_;
  HorizonMarch march_;
  std::vector<SunMoment> moments_;
};

}  // namespace lsos
