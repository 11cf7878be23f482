// Legs of a rover that cannot turn on the spot, against those of the same rover if it could.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numbers>

#include "base/random.h"
#include "physics/legs.h"

namespace lsos::test {
namespace {

// Seconds that planning takes.
double planned_in_s(const Ground& ground, const DriveCost& cost, const LegRequest& request,
                    PlannedLeg& leg) {
  const auto begin = std::chrono::steady_clock::now();
  leg = plan_leg(ground, cost, request);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(CarLikeLegs, are_found_where_a_rover_that_turns_on_the_spot_has_one) {
  int could = 0, found = 0, backs_up = 0, slow = 0;
  double slowest_s = 0, sum_s = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomStream random(mix_key(seed, "length"));
    const SeededLeg seeded{"LRV", "LunarSouthPole", seed, random.uniform(20, 1000)};
    const auto ground = seeded.ground();
    const DriveCost cost = cost_of(seeded, *ground);
    ASSERT_FALSE(cost.can_turn_on_spot);
    LegRequest request;
    request.goal_S_m = seeded.goal_S_m(*ground);
    request.seed = seed;
    request.start_heading_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
    DriveCost turning = cost;
    turning.can_turn_on_spot = true;
    if (!plan_leg(*ground, turning, request).is_found()) continue;
    PlannedLeg leg;
    const double took_s = planned_in_s(*ground, cost, request, leg);
    ++could;
    found += leg.is_found() ? 1 : 0;
    backs_up += leg.gear_changes.empty() ? 0 : 1;
    slow += took_s > 5 ? 1 : 0;
    slowest_s = std::max(slowest_s, took_s);
    sum_s += took_s;
    if (!leg.is_found() || took_s > 5) {
      std::printf("leg %llu of %.0f m in %.1f s: %s\n", static_cast<unsigned long long>(seed),
                  seeded.length_m, took_s, leg.reason.c_str());
    }
  }
  std::printf("%d of %d found, %d back up; %.2f s a leg, %d beyond 5 s, the slowest %.1f s\n",
              found, could, backs_up, sum_s / could, slow, slowest_s);
  EXPECT_GT(could, 150);
  EXPECT_GE(found, 0.95 * could);
}

}  // namespace
}  // namespace lsos::test
