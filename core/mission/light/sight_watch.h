// Who sees whom: when each pair of rovers, assets and Earth is looked at, what was seen, and who
// can talk to whom, directly or through others.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/archive.h"
#include "mission/light/looks_over_end.h"
#include "mission/light/sight.h"
#include "mission/port/motion.h"
#include "mission/port/rover_port.h"
#include "planet/utc.h"
#include "record/rows.h"

namespace lsos {

// So long does Earth take for 0.05 degrees of its way in the Moon's sky, where it only librates
// (1.8 degrees a day at most), and for 0.5 degrees in that of Mars.
SimTime earth_interval(const Body& body);

inline constexpr const char* earth_id = "Earth";

// That one end has seen another, or was linked to it, since then.
struct OpenInterval {
  SimTime start{};
  double light_time_s = 0;

  void archive(Archive& a) { a(start)(light_time_s); }
};

// One end of a line of sight, as it is at an exchange.
struct SightEnd {
  std::string id;
  Vec3 p_S_m = Vec3::Zero();  // reference point
  Vec3 antenna_S_m = Vec3::Zero();
  bool has_link = true;  // its antenna is up and works
  double range_max_m = std::numeric_limits<double>::infinity();
  bool reaches_earth = true;
  Motion motion = Motion::none;
  double reach_m = 0;           // all of its body lies so near to the reference point
  bool turns_with_sun = false;  // its panels do, though it stands
};

class SightWatch {
 public:
  // What may stand between two places, about the first, site axes.
  using SolidsBetween = std::function<Mesh(const Vec3& from_S_m, const Vec3& to_S_m)>;

  // Both must outlive it. Ends always come in the same order; Earth follows them, where it is not
  // the planet.
  SightWatch(const Ground& ground, Renderer& renderer, std::size_t ends);

  // Looks at the pairs that are due. Answers the intervals that end now.
  std::vector<SightIntervalRow> look(SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                                     const SolidsBetween& solids);
  // What was seen last between two ends, by number, Earth behind the others; absent: nothing yet.
  std::optional<PairSight> last(std::size_t one, std::size_t other) const;
  // What was seen last from that end to those that follow it.
  std::vector<PairRow> rows(SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                            std::size_t from) const;
  // Ends all that are under way.
  std::vector<SightIntervalRow> finish(SimTime now, const std::vector<SightEnd>& ends);
  // When something is to be looked at though nothing moves; absent: never.
  std::optional<SimTime> wake() const;

  // What was seen over the end of the ground.
  const LooksOverEnd& earth_over_end() const { return earth_over_end_; }
  const LooksOverEnd& pairs_over_end() const { return pairs_over_end_; }

  void archive(Archive& a) { a.tag("sight")(pairs_)(earth_over_end_)(pairs_over_end_); }

 private:
  // Ends by number; Earth is the last. State, held until the next look.
  struct Pair {
    std::size_t from = 0, to = 0;
    std::optional<SimTime> time;
    bool is_visible = false, is_linked = false;
    double fraction = not_modelled;
    bool is_near_turning = false;  // what turns with the Sun may stand between
    std::optional<OpenInterval> visible, linked;

    void archive(Archive& a) {
      a(from)(to)(time)(is_visible)(is_linked)(fraction)(is_near_turning)(visible)(linked);
    }
  };

  // What moves there may come between.
  bool is_near(const Pair& pair, const SightEnd& other, const std::vector<SightEnd>& ends) const;
  SimTime interval(const Pair& pair) const;
  bool is_due(const Pair& pair, SimTime now, const std::vector<SightEnd>& ends) const;
  void look_at(Pair& pair, SimTime now, Instant utc, const std::vector<SightEnd>& ends,
               const SolidsBetween& solids);
  double distance_m(const Pair& pair, Instant utc, const std::vector<SightEnd>& ends) const;
  std::string id(std::size_t end, const std::vector<SightEnd>& ends) const;
  std::string relay(const Pair& pair, const std::vector<SightEnd>& ends) const;

  const Ground* ground_;
  Sight sight_;
  LooksOverEnd earth_over_end_, pairs_over_end_;
  std::size_t earth_;  // its number
  std::vector<Pair> pairs_;
};

}  // namespace lsos
