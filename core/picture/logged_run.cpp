#include "picture/logged_run.h"

#include <algorithm>
#include <utility>

namespace lsos {

namespace {

constexpr double apart_m = 0.05, still_mps = 1e-3;

// A track with more points keeps every second and adds them at twice the distance: pictures show
// tracks of some hundred metres about a rover.
constexpr std::size_t track_points_max = 1'000'000;

struct Track {
  std::vector<TrackPoint> points;
  double spacing_m = apart_m;

  void add(const SampleRow& row) {
    if (!points.empty() && (row.p_S_m - points.back().p_S_m).norm() <= spacing_m) return;
    points.push_back({row.time, row.p_S_m});
    if (points.size() < track_points_max) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < points.size(); k += 2) points[kept++] = points[k];
    points.resize(kept);
    spacing_m *= 2;
  }
};

// Two successive samples of a rover with a requested time between them.
struct SamplePair {
  LoggedRover from;
  std::optional<LoggedRover> to;
};
using SamplePairs = std::vector<SamplePair>;  // at one time, one for each rover

// One rover's samples in order of time, as they come.
struct Follower {
  std::optional<SampleRow> last;
  std::size_t next = 0;  // index of the first time not filled in yet

  // `coming`: the sample after the last, if there is one.
  void fill(std::vector<SamplePairs>& moments, std::span<const SimTime> times,
            const SampleRow* coming) {
    for (; next < times.size() && (coming == nullptr || times[next] < coming->time); ++next) {
      if (!last) continue;
      moments[next].push_back({{*last, {}, {}}, {}});
      if (coming != nullptr && times[next] > last->time) {
        moments[next].back().to = LoggedRover{*coming, {}, {}};
      }
    }
  }
};

// Assigns rows of joints or panels to the samples of their time.
class RowAssigner {
 public:
  explicit RowAssigner(std::vector<SamplePairs>& moments) {
    for (SamplePairs& moment : moments) {
      for (SamplePair& stretch : moment) {
        want(stretch.from);
        if (stretch.to) want(*stretch.to);
      }
    }
  }
  template <class Row>
  void add(const Row& row, std::vector<Row> LoggedRover::*to) const {
    const auto found = wanted_.find({row.rover_id, row.time});
    if (found == wanted_.end()) return;
    for (LoggedRover* rover : found->second) (rover->*to).push_back(row);
  }
  // Time span of all samples; empty when there are none.
  const TimeSpan& span() const { return span_; }

 private:
  void want(LoggedRover& rover) {
    const SimTime time = rover.sample.time;
    wanted_[{rover.sample.rover_id, time}].push_back(&rover);
    span_ = {std::min(span_.from, time), std::max(span_.to, time)};
  }
  TimeSpan span_{SimTime::max(), SimTime::min()};
  std::map<std::pair<std::string, SimTime>, std::vector<LoggedRover*>> wanted_;
};

// Share 0..1 of the motion between two samples that is done. A parked rover has few samples; it
// moved up to `interval` after the first of them, or before the second.
double share_at(const SamplePair& stretch, SimTime time, SimTime interval) {
  SimTime start = stretch.from.sample.time, end = stretch.to->sample.time;
  if (end - start > interval) {
    const bool goes_on = stretch.from.sample.speed_mps > still_mps;
    (goes_on ? end : start) = goes_on ? start + interval : end - interval;
  }
  return std::clamp(seconds(time - start) / seconds(end - start), 0.0, 1.0);
}

// Height over the ground, the mean of nine places about the rover: rocks pass between its wheels.
double gap_m(Ground::Probe& probe, const Vec3& p_S_m) {
  double sum_m = 0;
  int count = 0;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      const GroundSample sample = probe.sample(p_S_m + Vec3(x, y, 0));
      if (!sample.is_ground()) continue;
      sum_m += sample.gap_m;
      ++count;
    }
  }
  return count > 0 ? sum_m / count : 0;
}

// The ground rises and falls between two samples: the height of the rover over it is interpolated.
LoggedRover at(const SamplePair& stretch, SimTime time, const Ground& ground, SimTime interval) {
  if (!stretch.to) return stretch.from;
  const double share = share_at(stretch, time, interval);
  LoggedRover rover = between(ground.site(), stretch.from, *stretch.to, share);
  const Vec3 &from_S_m = stretch.from.sample.p_S_m, &to_S_m = stretch.to->sample.p_S_m;
  if ((to_S_m - from_S_m).norm() < apart_m) return rover;
  Ground::Probe probe(ground);
  const double wanted_m = (1 - share) * gap_m(probe, from_S_m) + share * gap_m(probe, to_S_m);
  Vec3& p_S_m = rover.sample.p_S_m;
  p_S_m += (wanted_m - gap_m(probe, p_S_m)) * ground.site().up_S(p_S_m);
  return rover;
}

}  // namespace

LoggedRun read_logged(const LogReader& log, std::span<const SimTime> times, const Ground& ground,
                      SimTime interval) {
  LoggedRun run;
  std::vector<SamplePairs> moments(times.size());
  std::map<std::string, Follower> followers;
  std::map<std::string, Track> tracks;
  log.for_each_sample([&](const SampleRow& row) {
    if (times.empty()) return;
    Follower& follower = followers[row.rover_id];
    if (follower.next == times.size()) return;
    follower.fill(moments, times, &row);
    if (row.time > times.back()) return;
    follower.last = row;
    tracks[row.rover_id].add(row);
  });
  for (auto& [id, track] : tracks) run.tracks[id] = std::move(track.points);
  for (auto& [id, follower] : followers) follower.fill(moments, times, nullptr);
  const RowAssigner joiner(moments);
  log.for_each_joint([&](const JointRow& row) { joiner.add(row, &LoggedRover::joints); },
                     joiner.span());
  log.for_each_panel([&](const PanelRow& row) { joiner.add(row, &LoggedRover::panels); },
                     joiner.span());
  for (std::size_t k = 0; k < times.size(); ++k) {
    LoggedMoment& moment = run.moments.emplace_back();
    for (const SamplePair& stretch : moments[k]) {
      moment.push_back(at(stretch, times[k], ground, interval));
    }
    std::ranges::sort(moment, {}, [](const LoggedRover& rover) { return rover.sample.rover_id; });
  }
  return run;
}

}  // namespace lsos
