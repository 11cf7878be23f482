// Lines of sight over time: when each pair of rovers, assets and Earth is evaluated, what was
// visible, and who is linked to whom, directly or through relays.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/archive.h"
#include "mission/light/sight.h"
#include "mission/light/sight_over_end.h"
#include "mission/port/motion.h"
#include "mission/port/rover_port.h"
#include "planet/utc.h"
#include "record/rows.h"

namespace lsos {

// Time in which Earth moves 0.05 degrees in the sky of the Moon, where it only librates (1.8
// degrees a day at most), or 0.5 degrees in that of Mars.
SimTime earth_interval(const Body& body);

inline constexpr const char* earth_id = "Earth";

// An open row of the layer `sight_intervals`.
struct OpenInterval {
  SimTime start{};
  double light_time_s = 0;
  std::string by;

  void archive(Archive& a) { LSOS_ARCHIVE(a, start, light_time_s, by); }
};

// Distance by which panels, and limbs that have moved from their rest, may stand out of the reach
// of a body. A body blocks no line that passes it farther away.
inline constexpr double beyond_reach_m = 10;

// One end of a line of sight at an exchange.
struct SightEnd {
  std::string id;
  Vec3 p_S_m = Vec3::Zero();  // reference point
  Vec3 antenna_S_m = Vec3::Zero();
  bool has_link = true;  // its antenna is up and works
  double range_max_m = std::numeric_limits<double>::infinity();
  bool reaches_earth = true;
  Motion motion = Motion::none;
  double reach_m = 0;           // radius about the reference point that holds its body at rest
  bool turns_with_sun = false;  // its panels follow the Sun, though it stands still
};

class SightWatch {
 public:
  // Returns the bodies that may stand between two places, relative to the first, site axes.
  using SolidsBetween =
      std::function<std::vector<NamedMesh>(const Vec3& from_S_m, const Vec3& to_S_m)>;

  // `ground` and `renderer` must outlive it. Ends are always passed in the same order; Earth
  // follows them unless it is the planet.
  // `is_estimate`: Earth is evaluated `estimate_steps` times less often and with one march,
  // other pairs only when ask() does.
  SightWatch(const Ground& ground, Renderer& renderer, std::size_t ends, bool is_estimate = false);
  static constexpr int estimate_steps = 6;

  // Evaluates the pairs that are due. Returns the intervals that end now.
  std::vector<SightIntervalRow> look(SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                                     const SolidsBetween& solids);
  // Last result between two ends, by number, Earth after the others; absent: none yet.
  std::optional<PairSight> last(std::size_t one, std::size_t other) const;
  // In an estimate: evaluates a pair now, where its last result is more than a minute old.
  void ask(std::size_t one, std::size_t other, SimTime now, Instant utc,
           const std::vector<SightEnd>& ends, const SolidsBetween& solids);
  // Rows of the last results from one end to those after it.
  std::vector<PairRow> rows(SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                            std::size_t from) const;
  // Ends all open intervals and returns them.
  std::vector<SightIntervalRow> finish(SimTime now, const std::vector<SightEnd>& ends);
  // Warns of ends that could have been linked to Earth for an hour or more in all, but for their
  // own bodies.
  std::vector<std::string> warnings_of_own_way(const std::vector<SightEnd>& ends) const;
  // When a pair is next due if nothing moves; absent: never.
  std::optional<SimTime> wake() const;

  // Lines of sight over the end of the known ground.
  const SightOverEnd& earth_over_end() const { return earth_over_end_; }
  const SightOverEnd& pairs_over_end() const { return pairs_over_end_; }

  void archive(Archive& a) {
    a.tag("sight");
    const std::vector<Pair> before = pairs_;
    LSOS_ARCHIVE(a, pairs_, earth_over_end_, pairs_over_end_);
    const auto are_same_ends = [](const Pair& one, const Pair& other) {
      return one.from == other.from && one.to == other.to;
    };
    if (!std::ranges::equal(pairs_, before, are_same_ends))
      a.refuse("saved state is of other ends");
  }

 private:
  // Ends by number, Earth last. The results hold until the next evaluation.
  struct Pair {
    std::size_t from = 0, to = 0;
    std::optional<SimTime> time;
    bool is_visible = false, is_linked = false;
    double fraction = not_modelled;
    std::string hidden_by;         // what hides it while it is not visible
    bool is_near_turning = false;  // panels that follow the Sun may stand in between
    std::optional<OpenInterval> visible, hidden, linked, relayed;
    SimTime in_own_way{};  // its `from` could have been linked to Earth but for its own body

    void archive(Archive& a) {
      LSOS_ARCHIVE(a, from, to, time, is_visible, is_linked, fraction, hidden_by, is_near_turning,
                   visible, hidden, linked, relayed, in_own_way);
    }
  };

  // Whether `other`, when it moves, may come in between.
  bool is_near(const Pair& pair, const SightEnd& other, const std::vector<SightEnd>& ends) const;
  SimTime interval(const Pair& pair) const;
  bool is_due(const Pair& pair, SimTime now, const std::vector<SightEnd>& ends) const;
  // Counts the time since its last evaluation, for which that result held.
  void count_own_way(Pair& pair, SimTime now, const std::vector<SightEnd>& ends) const;
  void evaluate(Pair& pair, SimTime now, Instant utc, const std::vector<SightEnd>& ends,
                const SolidsBetween& solids);
  // Opens and ends intervals by what the pair's state is now.
  void follow(Pair& pair, SimTime now, Instant utc, const std::vector<SightEnd>& ends,
              std::vector<SightIntervalRow>& ended) const;
  SightIntervalRow row(const Pair& pair, const char* kind, const OpenInterval& interval,
                       SimTime end, const std::vector<SightEnd>& ends) const;
  // The pair's four intervals by kind.
  static std::array<std::pair<const char*, std::optional<OpenInterval>*>, 4> intervals(Pair& pair);
  double distance_m(const Pair& pair, Instant utc, const std::vector<SightEnd>& ends) const;
  std::string id(std::size_t end, const std::vector<SightEnd>& ends) const;
  // The relays that join a pair without a direct link, comma-separated; "" when none do.
  std::string relay(const Pair& pair, const std::vector<SightEnd>& ends) const;

  const Ground* ground_;
  Sight sight_;
  SightOverEnd earth_over_end_, pairs_over_end_;
  std::size_t earth_;  // number of Earth as an end
  bool is_estimate_;
  std::vector<Pair> pairs_;
};

}  // namespace lsos
