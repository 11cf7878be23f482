// Three SEVs in a convoy over craters: the second follows the first, the third follows the second.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "base/segment.h"
#include "system/moon_ground.h"
#include "system/plan_run.h"

namespace lsos::test {
namespace {

constexpr double distance_m = 20;

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

// The leader stands at first and nothing else happens. The follower sets off at the exchange after
// its event began, whatever else is logged then.
TEST(Convoy, closes_up_to_a_parked_leader_at_once_however_often_is_logged) {
  const auto plan = [](const char* interval, const Fields& more = {}) {
    return std::vector<Mark>{mission({{"LogInterval", "1"}, {"ParkedLogInterval", interval}}),
                             rover("A", 0),
                             rover("B", -3 * distance_m),
                             event("Pause", "A", 1, {{"Duration", "200"}}),
                             event("Pause", "B", 1, {{"Duration", "3.7"}}),
                             event("Follow", "B", 2, [&] {
                               Fields fields{{"Leader", "A"}};
                               fields.insert(fields.end(), more.begin(), more.end());
                               return fields;
                             }())};
  };
  std::map<double, Vec3> places;
  for (const SampleRow& row : PlanRun(plan("10")).samples()) {
    if (row.rover_id == "B") places[seconds(row.time)] = row.p_S_m;
  }
  std::size_t compared = 0;
  for (const SampleRow& row : PlanRun(plan("60")).samples()) {
    const auto then = places.find(seconds(row.time));
    if (row.rover_id != "B" || then == places.end()) continue;
    ++compared;
    EXPECT_EQ(row.p_S_m, then->second) << "at " << then->first << " s";
  }
  EXPECT_GT(compared, 20u);
  EXPECT_GT((places.at(20) - places.at(0)).norm(), 1);
  const Fields until_then{{"Duration", "100"}};
  EXPECT_EQ(digest_of(TempFolder(), plan("60", until_then), {"--save-every-exchange"}),
            digest_of(TempFolder(), plan("60", until_then)));
}

// Nothing of the leader's ever ends again that could wake a parked follower.
TEST(Convoy, behind_a_leader_that_has_ended_ends_at_once) {
  const auto ends_s = [](const Fields& more, bool has_events) {
    Fields fields{{"Leader", "A"}};
    fields.insert(fields.end(), more.begin(), more.end());
    std::vector<Mark> plan{mission(), rover("A", 0), rover("B", -distance_m),
                           event("Follow", "B", 1, fields)};
    if (has_events) plan.push_back(event("Pause", "A", 1, {{"Duration", "30"}}));
    const PlanRun run(plan);
    EXPECT_EQ(run.outcome.exit_code, 0) << run.outcome.err;
    for (const nlohmann::json& each : run.summary()["events"]) {
      if (each["type"] == "Follow") return each["end_s"].get<double>();
    }
    return -1.0;
  };
  EXPECT_LT(ends_s({}, false), 1) << "a leader without events";
  EXPECT_LT(ends_s({{"StartTime", "2026-01-01T00:05:00Z"}}, true), 301) << "a later StartTime";
  EXPECT_LT(ends_s({{"StartAfter", "A/1"}}, true), 31) << "StartAfter";
}

}  // namespace
}  // namespace lsos::test
