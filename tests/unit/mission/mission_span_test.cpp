#include "mission/model/mission_span.h"

#include <gtest/gtest.h>

#include "test_mission.h"

namespace lsos {
namespace {

using test::Mission;

constexpr double hour_s = 3600;

// Default MaxDuration in hours, for mock events: Hold with a duration, Drive with a speed.
double hours_of(Mission& mission, bool is_open_ended = false) {
  Declarations declarations;
  const auto duration = [] {
    FieldDeclaration field;
    field.name = "Duration";
    field.key = "duration_s";
    field.kind = FieldKind::duration;
    return field;
  }();
  declarations.events["Hold"].fields = {duration};
  FieldDeclaration speed;
  speed.name = "Speed";
  speed.key = "speed_mps";
  speed.kind = FieldKind::number;
  speed.role = NumberRole::drive_speed;
  declarations.events["Drive"].fields = {speed};
  declarations.events["Drive"].drives = true;
  return seconds(default_max_duration(mission.setup_.plan, declarations,
                                      mission.setup_.rover_models,
                                      [&](const PlanEvent&) { return is_open_ended; })) /
         hour_s;
}

TEST(MissionSpan, is_a_day_and_all_durations_in_whole_hours) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 1.5 * hour_s);
  EXPECT_EQ(hours_of(mission), 26);
  mission.event("Hold", 0.5 * hour_s);
  EXPECT_EQ(hours_of(mission), 26);
  mission.event("Hold", 100 * hour_s).is_enabled = false;
  EXPECT_EQ(hours_of(mission), 26);
}

TEST(MissionSpan, begins_at_the_latest_time_of_the_plan) {
  Mission mission;
  mission.rover("A");
  mission.event("Hold", 60).start_time =
      mission.setup_.plan.mission.start_time + from_seconds(48 * hour_s);
  EXPECT_EQ(hours_of(mission), 73);
}

// 12 km at 1 m/s there, and back: three times 24 km are 20 h.
TEST(MissionSpan, is_three_times_what_is_drawn_at_the_speed_asked_for) {
  Mission mission;
  mission.rover("A");
  mission.drive(12000).params["speed_mps"] = 1.0;
  mission.drive(0).params["speed_mps"] = 1.0;
  EXPECT_EQ(hours_of(mission), 24 + 20);
}

TEST(MissionSpan, is_a_year_where_a_condition_decides) {
  Mission waits;
  waits.rover("A");
  waits.event("Hold", 1).start_when = {"charge > 0.5", 1};
  EXPECT_EQ(hours_of(waits), 366 * 24);
  Mission stops;
  stops.rover("A");
  stops.event("Hold", 1).stop_when = {"charge < 0.5", 1};
  EXPECT_EQ(hours_of(stops), 366 * 24);
  Mission open;
  open.rover("A");
  open.event("Hold", 1);
  EXPECT_EQ(hours_of(open, true), 366 * 24);
}

}  // namespace
}  // namespace lsos
