// Three SEVs in a convoy over craters: the second follows the first, the third follows the second.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/segment.h"
#include "base/units.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

constexpr double distance_m = 20;

std::string place(double east_m, double north_m) {
  constexpr double moon_m = 1737400;
  return fmt::format("{:.9f},{:.9f}", degrees(east_m / moon_m), degrees(north_m / moon_m));
}

// They stand in a line and look ahead: a rover that had to turn first would lag behind.
Mark rover(const std::string& id, double east_m) {
  Mark mark = sev(id, place(east_m, 0));
  mark.fields.push_back({"Heading", "90"});
  return mark;
}

Mark follower(const std::string& id, const std::string& leader) {
  return event("Follow", id, 1, {{"Leader", leader}, {"Distance", fmt::format("{}", distance_m)}});
}

std::vector<Mark> convoy(double length_m, const char* log_interval) {
  Mark info = mission({{"LogInterval", log_interval}, {"Seed", "1"}});
  for (auto& [field, value] : info.fields) {
    if (field == "Terrain") value = "Craters";
  }
  return {info,
          rover("A", 0),
          rover("B", -distance_m),
          rover("C", -2 * distance_m),
          event("PathPlanRoute", "A", 1, {}, point(place(length_m, 0.2 * length_m))),
          follower("B", "A"),
          follower("C", "B")};
}

struct Track {
  std::vector<Vec2> places;
  std::vector<double> lengths_m;  // up to each place
};

Track track_of(const std::vector<SampleRow>& samples, const std::string& id) {
  Track track;
  for (const SampleRow& row : samples) {
    if (row.rover_id != id) continue;
    const Vec2 p = row.p_S_m.head<2>();
    const double step_m = track.places.empty() ? 0 : (p - track.places.back()).norm();
    track.lengths_m.push_back(track.places.empty() ? 0 : track.lengths_m.back() + step_m);
    track.places.push_back(p);
  }
  return track;
}

// The gaps along the leader's track at each sample, from when the follower has driven its Distance
// on that track.
std::vector<double> gaps_m(const Track& leader, const Track& follower) {
  std::vector<double> gaps;
  double reached_m = 0;
  for (std::size_t now = 1; now < std::min(leader.places.size(), follower.places.size()); ++now) {
    double least_m = 1e9, at_m = reached_m;
    for (std::size_t i = 0; i < now; ++i) {
      if (leader.lengths_m[i + 1] < reached_m - 1 || leader.lengths_m[i] > reached_m + 5) continue;
      const Vec2 &a = leader.places[i], &b = leader.places[i + 1];
      const double away_m = point_distance_m(a, b, follower.places[now]);
      if (away_m >= least_m) continue;
      least_m = away_m;
      at_m = leader.lengths_m[i] + nearest_share(a, b, follower.places[now]) * (b - a).norm();
    }
    if (least_m > 2) continue;
    reached_m = at_m;
    if (reached_m > distance_m) gaps.push_back(leader.lengths_m[now] - reached_m);
  }
  return gaps;
}

TEST(Convoy, of_three_keeps_its_distance_over_a_kilometre_of_craters) {
  const PlanRun run(convoy(1000, "1"));
  EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
  const std::vector<SampleRow> samples = run.samples();
  for (const auto& [first, second] : {std::pair("A", "B"), std::pair("B", "C")}) {
    const Track leader = track_of(samples, first);
    EXPECT_GT(leader.lengths_m.back(), 1000);
    std::vector<double> gaps = gaps_m(leader, track_of(samples, second));
    ASSERT_GT(gaps.size(), 300u);
    std::ranges::sort(gaps);
    const auto share = [&](double of) {
      return gaps[static_cast<std::size_t>(of * static_cast<double>(gaps.size() - 1))];
    };
    fmt::print("{} behind {}: {:.2f} to {:.2f} m, 5th to 95th percentile {:.2f} to {:.2f} m\n",
               second, first, gaps.front(), gaps.back(), share(0.05), share(0.95));
    EXPECT_GT(gaps.front(), 0.8 * distance_m);
    EXPECT_LT(gaps.back(), 1.2 * distance_m);
  }
}

TEST(Convoy, gives_the_same_log_on_any_threads_and_saved_at_each_exchange) {
  std::vector<std::string> digests;
  for (const Words& options :
       std::vector<Words>{{"--threads", "1"}, {"--threads", "3"}, {"--save-every-exchange"}}) {
    const PlanRun run(convoy(60, "2"), options);
    EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    digests.push_back(run.summary()["log_sha256"]);
  }
  EXPECT_EQ(digests[1], digests[0]) << "on three threads";
  EXPECT_EQ(digests[2], digests[0]) << "saved at each exchange";
}

}  // namespace
}  // namespace lsos::test
