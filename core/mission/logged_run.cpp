#include "mission/logged_run.h"

#include <algorithm>
#include <utility>

namespace lsos {

namespace {

constexpr double apart_m = 0.05;

// One rover's samples in order of time, as they come.
struct Follower {
  std::optional<SampleRow> last;
  std::size_t next = 0;  // of the times, that has no sample yet

  // `before`: the time of the sample that comes.
  void fill(std::vector<LoggedMoment>& moments, std::span<const SimTime> times, SimTime before) {
    for (; next < times.size() && times[next] < before; ++next) {
      if (last) moments[next].push_back({*last, {}, {}});
    }
  }
};

// Rows of joints or panels to the samples of their time.
template <class Row>
void join(std::vector<LoggedMoment>& moments, const std::vector<Row>& rows,
          std::vector<Row> LoggedRover::*to) {
  std::map<std::pair<std::string, SimTime>, std::vector<LoggedRover*>> wanted;
  for (LoggedMoment& moment : moments) {
    for (LoggedRover& rover : moment) {
      wanted[{rover.sample.rover_id, rover.sample.time}].push_back(&rover);
    }
  }
  for (const Row& row : rows) {
    const auto found = wanted.find({row.rover_id, row.time});
    if (found == wanted.end()) continue;
    for (LoggedRover* rover : found->second) (rover->*to).push_back(row);
  }
}

}  // namespace

LoggedRun read_logged(const LogReader& log, std::span<const SimTime> times) {
  LoggedRun run;
  run.moments.resize(times.size());
  std::map<std::string, Follower> followers;
  log.for_each_sample([&](const SampleRow& row) {
    if (times.empty() || row.time > times.back()) return;
    Follower& follower = followers[row.rover_id];
    follower.fill(run.moments, times, row.time);
    follower.last = row;
    std::vector<TrackPoint>& track = run.tracks[row.rover_id];
    if (track.empty() || (row.p_S_m - track.back().p_S_m).norm() > apart_m) {
      track.push_back({row.time, row.p_S_m});
    }
  });
  for (auto& [id, follower] : followers) follower.fill(run.moments, times, SimTime::max());
  for (LoggedMoment& moment : run.moments) {
    std::ranges::sort(moment, {}, [](const LoggedRover& rover) { return rover.sample.rover_id; });
  }
  join(run.moments, log.joints(), &LoggedRover::joints);
  join(run.moments, log.panels(), &LoggedRover::panels);
  return run;
}

}  // namespace lsos
