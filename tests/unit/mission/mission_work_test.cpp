// What a mission has yet to do, and the time that its simulation is said to take.
#include "mission/ahead/mission_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/sim_time.h"
#include "test_mission.h"

namespace lsos {
namespace {

constexpr double an_hour_s = 3600;

// A made-up month: each day a drive of some hours from 8 h on, the rest it stands. Simulated drives
// take `wall_per_hour_s` of wall time an hour, standing next to nothing.
struct Month {
  double drive_hours_of(int day) const { return day % 7 == 6 ? 0 : 1 + day % 3; }
  static constexpr int days = 28;
  static constexpr double wall_per_hour_s = 40, stand_wall_per_hour_s = 0.02;

  double all_drive_s() const {
    double sum_s = 0;
    for (int day = 0; day < days; ++day) sum_s += an_hour_s * drive_hours_of(day);
    return sum_s;
  }
  // Calls visit(wall time so far, mission time, work, estimate) after each hour; returns the wall
  // time of all. Drives take `longer` times what is planned.
  template <class Visit>
  double run(double longer, const Visit& visit) const {
    MissionWork work{0, all_drive_s(), days * day_length_s};
    TimeLeft left(work);
    double wall_s = 0;
    for (int day = 0; day < days; ++day) {
      double to_drive_hours = longer * drive_hours_of(day);
      for (int hour = 0; hour < 24; ++hour) {
        const double driven = hour < 8 ? 0 : std::min(1.0, to_drive_hours);
        to_drive_hours -= driven;
        const double drive_wall_s = driven * wall_per_hour_s;
        const double stand_wall_s = (1 - driven) * stand_wall_per_hour_s;
        if (driven > 0) left.add(drive_wall_s, driven * an_hour_s, true);
        if (driven < 1) left.add(stand_wall_s, (1 - driven) * an_hour_s, false);
        wall_s += drive_wall_s + stand_wall_s;
        work.driven_s += driven * an_hour_s / longer;
        work.to_drive_s = std::max(0.0, work.to_drive_s - driven * an_hour_s / longer);
        const double now_s = day * day_length_s + (hour + 1) * an_hour_s;
        visit(wall_s, now_s, left.left_s(work, now_s));
      }
    }
    return wall_s;
  }
};

// Greatest error of the estimate, as a share of the time of the whole run.
double greatest_error(double longer) {
  const Month month;
  const double all_s = month.run(longer, [](double, double, std::optional<double>) {});
  double greatest = 0;
  month.run(longer, [&](double wall_s, double, std::optional<double> left_s) {
    if (left_s) greatest = std::max(greatest, std::abs(wall_s + *left_s - all_s) / all_s);
  });
  return greatest;
}

TEST(TimeLeft, is_right_over_quiet_and_driving_hours) {
  EXPECT_LT(greatest_error(1), 0.01);
  EXPECT_LT(greatest_error(1.3), 0.01) << "drives that take longer than planned";
}

TEST(TimeLeft, is_unknown_until_something_has_been_driven) {
  Month month;
  int unknown = 0;
  month.run(1, [&](double, double, std::optional<double> left_s) { unknown += !left_s; });
  EXPECT_EQ(unknown, 8) << "hours before the first drive";
}

TEST(TimeLeft, by_mission_time_would_be_far_off) {
  // The reason for counting drives: half of the month's last week is quiet.
  const Month month;
  const double all_s = month.run(1, [](double, double, std::optional<double>) {});
  double greatest = 0;
  month.run(1, [&](double wall_s, double now_s, std::optional<double>) {
    if (now_s < day_length_s / 2) return;
    const double naive_s = wall_s * Month::days * day_length_s / now_s;
    greatest = std::max(greatest, std::abs(naive_s - all_s) / all_s);
  });
  EXPECT_GT(greatest, 0.1);
}

TEST(MissionWork, counts_drives_that_are_done_and_those_to_come) {
  test::Mission mission;
  mission.rover("A");
  const PlanRover rover = mission.setup_.plan.rovers.front();
  const Body& moon = *find_body("Moon");
  EventMachine drive;
  drive.event.type = "Drive";
  drive.declaration.drives = true;
  FieldDeclaration speed;
  speed.name = "Speed";
  speed.key = "speed_mps";
  speed.kind = FieldKind::number;
  speed.role = NumberRole::drive_speed;
  drive.declaration.fields = {speed};
  drive.event.params["speed_mps"] = 1.0;
  RoverMachine machine{rover, {}};
  for (int k = 1; k <= 3; ++k) {
    Geodetic there = rover.start;
    there.lat_rad += k * 100 / moon.equatorial_radius_m;  // 100 m each
    drive.event.geometry = {GeometryKind::point, {there}};
    machine.events.push_back(drive);
  }
  EventRecords records(3);
  records[0].start = SimTime{0};
  records[0].end = SimTime{100'000'000};
  records[1].start = records[0].end;
  const auto work_of = [&](bool is_finished) {
    MissionWork work;
    add_work(machine, records, mission.setup_.rover_models.at("Test"), mission.setup_.plan.mission,
             SimTime{140'000'000}, 0.4, is_finished, work);
    return work;
  };
  const MissionWork work = work_of(false);
  EXPECT_NEAR(work.driven_s, 140, 1e-3);
  EXPECT_NEAR(work.to_drive_s, 160, 1e-3);
  EXPECT_NEAR(work.stand_until_s, 300, 1e-3);
  EXPECT_NEAR(work_of(true).to_drive_s, 60, 1e-3) << "the third will never begin";
}

}  // namespace
}  // namespace lsos
