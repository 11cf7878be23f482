// ATHLETE in missions: obstacles that it drives over, saved state, runs that are equal.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "system/moon_ground.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

// A ridge of rock 0.95 m high from end to end of the map, whose sides rise by 37 degrees. Its crest
// is a line of cells.
void write_ridge(const TempFolder& folder) {
  write_raster(folder, "ridge", 120, [](double x_m, double) {
    return std::max(0.0, 0.95 * (1 - std::abs(x_m - 0.25) / 1.25));
  });
  write_terrain(folder, "Ridge", "lsos.raster { file = 'ridge.asc' }", "'Rock'");
}

std::vector<Mark> crossing(const std::string& type, const std::string& route,
                           const Fields& more = {}) {
  return {on("Ridge"), rover(type, "A", place(-10, 0), more),
          event(route, "A", 1, {{"Speed", "0.3"}}, point(place(10, 0)))};
}

// Whether the plan is refused since there is no route over the ridge.
bool is_refused(const TempFolder& folder, const std::vector<Mark>& marks) {
  const Outcome outcome =
      run({folder.write("plan.kml", kml(marks)), "-o", folder / "run", "--quiet", "--no-report"});
  return outcome.exit_code == 2 &&
         outcome.err.find("the nearest place that can be reached") != std::string::npos;
}

double number(const RunResult& result, const std::string& sql) {
  return std::stod(query(result.log, sql));
}

TEST(Limbs, carry_a_chassis_over_what_stops_one_on_wheels) {
  TempFolder sev_folder, drawn_folder, athlete_folder, stowed_folder;
  for (const TempFolder* folder : {&sev_folder, &drawn_folder, &athlete_folder, &stowed_folder}) {
    write_ridge(*folder);
  }
  EXPECT_TRUE(is_refused(sev_folder, crossing("SEV", "PathPlanRoute")));
  // The plan is right: driven all the same, it sits on the ridge.
  const RunResult drawn = run_plan(drawn_folder, crossing("SEV", "Route"));
  EXPECT_EQ(drawn.event("status"), "failed");
  EXPECT_THAT(drawn.event("reason"), HasSubstr("high-centred"));

  const RunResult athlete =
      run_plan(athlete_folder, crossing("ATHLETE", "PathPlanRoute", {{"RoverConfig", "Tall"}}));
  EXPECT_EQ(athlete.event("status"), "completed");
  const double planned_s = number(athlete, "select sum(duration_s) from planned_paths");
  const double driven_s = number(athlete, "select end_s - start_s from events");
  EXPECT_NEAR(planned_s, driven_s, 0.2 * driven_s);

  // Low, it is stopped too.
  EXPECT_TRUE(
      is_refused(stowed_folder, crossing("ATHLETE", "PathPlanRoute", {{"RoverConfig", "Stow"}})));
}

TEST(Limbs, routes_after_a_change_of_stance_are_for_the_new_one) {
  const TempFolder folder;
  write_ridge(folder);
  const RunResult result = run_plan(
      folder, {on("Ridge"), rover("ATHLETE", "A", place(-10, 0), {{"RoverConfig", "Stow"}}),
               event("SetPosture", "A", 1, {{"Stance", "Tall"}}),
               event("PathPlanRoute", "A", 2, {}, point(place(10, 0)))});
  EXPECT_EQ(result.event("status", 1), "completed") << result.event("reason", 1);
}

TEST(Limbs, that_cannot_level_the_chassis_are_warned_of) {
  const TempFolder folder;
  write_terrain(folder, "Hill", "lsos.plane { slope_rad = math.rad(10) }", "'ApolloNominal'");
  const RunResult result =
      run_plan(folder, {on("Hill"), rover("ATHLETE", "A", place(0, 0)),
                        event("Fault", "A", 1, {{"What", "limb"}}),
                        event("Route", "A", 2, {}, line(place(5, 0) + " " + place(5, 5))),
                        event("Pause", "A", 3, {{"Duration", "30"}}, "")});
  EXPECT_EQ(result.event("status", 1), "completed");
  EXPECT_THAT(result.summary["warnings"].dump(), HasSubstr("A: stands tilted by "));
}

// The limbs down the slope are at their ends, so that it stands lower.
TEST(Limbs, that_do_not_reach_their_stance_at_the_start_are_warned_of) {
  const TempFolder folder;
  write_terrain(folder, "Hill", "lsos.plane { slope_rad = math.rad(18) }", "'ApolloNominal'");
  const RunResult result =
      run_plan(folder, {on("Hill"), rover("ATHLETE", "A", place(0, 0), {{"RoverConfig", "Tall"}}),
                        event("Pause", "A", 1, {{"Duration", "30"}}, "")});
  EXPECT_THAT(result.summary["warnings"].dump(), HasSubstr("A: its chassis is 1."));
  EXPECT_THAT(result.summary["warnings"].dump(), HasSubstr("over the ground instead of 1.90 m"));
}

TEST(Limbs, do_not_change_runs_that_are_saved_and_read_back_at_each_exchange) {
  const std::vector<Mark> plan{
      {"MissionInfo",
       {{"Planet", "Moon"}, {"StartTime", "2026-01-01"}, {"Terrain", "Craters"}},
       ""},
      rover("ATHLETE", "A", place(0, 0)),
      rover("ATHLETE", "B", place(0, 15)),
      event("Route", "A", 1, {}, point(place(6, 0))),
      event("SetPosture", "A", 2, {{"Stance", "Tall"}, {"Duration", "30"}}),
      event("Route", "A", 3, {}, point(place(6, 4))),
      event("SetPosture", "B", 1, {{"Height", "0.5"}, {"Level", "false"}}),
      event("Route", "B", 2, {}, point(place(6, 15)))};
  const std::string digest = digest_of(TempFolder(), plan, {"--threads", "1"});
  EXPECT_EQ(digest.size(), 64u);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--save-every-exchange"}), digest);
  EXPECT_EQ(digest_of(TempFolder(), plan, {"--threads", "2"}), digest);
}

}  // namespace
}  // namespace lsos::test
