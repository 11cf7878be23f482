// The drive cost model that planning uses, against shipped rovers driven up the same slopes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/units.h"
#include "mission/routes/drive_cost_model.h"
#include "physics/drive.h"
#include "planet/ellipsoid.h"

namespace lsos::test {
namespace {

struct ModelledClimb {
  const char *rover, *planet, *soil;
  double speed_mps, length_m, slopes_deg[3];
};

class DriveTable : public testing::TestWithParam<ModelledClimb> {};

// Energy of a metre with that of the motors' controllers, J/m.
double metre_j(const DriveCost& cost, const SlopeDrive& drive) {
  return drive.energy_jpm + cost.idle_w / drive.speed_mps;
}

double rover_efficiency(const VehicleConfig& rover) {
  for (const LinkConfig& link : rover.links) {
    if (link.drive) return link.drive->efficiency;
  }
  return 0;
}

// The difference of two lengths of drive excludes starting and stopping. The wheels of a vehicle
// carry unequal loads, those of the table equal ones.
TEST_P(DriveTable, has_the_energy_of_the_simulated_rover) {
  const ModelledClimb& climb = GetParam();
  for (const double slope_deg : climb.slopes_deg) {
    const auto slope =
        ground({climb.planet, PlaneSurface{0, radians(slope_deg), radians(180)}, climb.soil});
    const VehicleConfig rover = rover_on(climb.rover, *slope, climb.planet);
    const double g_mps2 = gravity_mps2(*find_body(climb.planet), start);
    const DriveCost cost = drive_cost(rover, slope->soils(), g_mps2, climb.speed_mps);
    ASSERT_GT(cost.soils[0].last_rad(), radians(slope_deg));
    const SlopeDrive table = cost.soils[0].at(radians(slope_deg));
    const double level = std::cos(radians(slope_deg));
    const auto go = [&](double length_m) {
      return drive(rover, *slope, {{0, length_m * level}}, climb.speed_mps);
    };
    const DriveResult far = go(2 * climb.length_m), near = go(climb.length_m);
    ASSERT_EQ(far.failure + near.failure, "");
    const double driven_jpm = (far.drive_j - near.drive_j) / (far.distance_m - near.distance_m);
    const std::string what = fmt::format("{} {} deg: table {:.1f} J/m, driven {:.1f}", climb.rover,
                                         slope_deg, metre_j(cost, table), driven_jpm);
    RecordProperty(fmt::format("slope_{}", slope_deg), what);
    EXPECT_NEAR(metre_j(cost, table), driven_jpm, 0.02 * driven_jpm) << what;
    const double driven_mps =
        (far.distance_m - near.distance_m) / (far.duration_s - near.duration_s);
    EXPECT_NEAR(table.speed_mps, driven_mps, 0.02 * driven_mps) << what;
  }
}

// Losses by load and by time make a metre dearer at low speed; the table must follow. LRV took 35
// to 90 Wh/km on the level, 126 to 324 J/m (Apollo 15 to 17, see VALIDATION.md).
TEST(DriveLosses, are_in_the_table_as_in_the_simulated_rover) {
  const auto level = ground({"Moon", PlaneSurface{}, "ApolloNominal"});
  const VehicleConfig rover = rover_on("LRV", *level, "Moon");
  const auto driven_jpm_at = [&](double speed_mps) {
    const DriveCost cost =
        drive_cost(rover, level->soils(), gravity_mps2(*find_body("Moon"), start), speed_mps);
    const SlopeDrive table = cost.soils[0].at(0);
    const DriveResult far = drive(rover, *level, {{0, 120}}, speed_mps);
    const DriveResult near = drive(rover, *level, {{0, 60}}, speed_mps);
    EXPECT_EQ(far.failure + near.failure, "");
    const double driven_jpm = (far.drive_j - near.drive_j) / (far.distance_m - near.distance_m);
    EXPECT_NEAR(metre_j(cost, table), driven_jpm, 0.02 * driven_jpm) << speed_mps;
    EXPECT_GT(driven_jpm, 126) << speed_mps;
    EXPECT_LT(driven_jpm, 324) << speed_mps;
    RecordProperty(fmt::format("at_{}_mps", speed_mps), fmt::format("{:.1f} J/m", driven_jpm));
    return driven_jpm;
  };
  EXPECT_GT(driven_jpm_at(1), driven_jpm_at(3.6) + 10);
}

INSTANTIATE_TEST_SUITE_P(
    Rovers, DriveTable,
    testing::Values(ModelledClimb{"SEV", "Moon", "ApolloNominal", 1, 20, {0, 8, 15}},
                    ModelledClimb{"LRV", "Moon", "ApolloNominal", 1, 60, {0, 8, 15}},
                    ModelledClimb{"MER", "Mars", "MMS", 0.035, 1.5, {0, 5, 10}},
                    ModelledClimb{"ATHLETE", "Moon", "ApolloNominal", 0.4, 10, {0, 5, 10}},
                    ModelledClimb{"Husky", "Earth", "Hardpan", 0.5, 10, {0, 8, 15}}),
    [](const auto& tested) { return std::string(tested.param.rover); });

// `spare_jpm` is the energy that brakes and motors take up downhill, as the electrical energy that
// it stands for. The drives are without the losses that a motor covers as a generator.
TEST(DriveTableDownhill, spares_what_the_brakes_of_the_simulated_rover_take) {
  for (const char* name : {"SEV", "LRV"}) {
    for (const double slope_deg : {-10.0, -15.0}) {
      const auto slope =
          ground({"Moon", PlaneSurface{0, radians(slope_deg), radians(180)}, "ApolloNominal"});
      VehicleConfig rover = rover_on(name, *slope, "Moon");
      for (LinkConfig& link : rover.links) {
        if (link.drive) link.drive->winding_loss_w_pn2m2 = link.drive->friction_n_m = 0;
      }
      const double g_mps2 = gravity_mps2(*find_body("Moon"), start);
      const DriveCost cost = drive_cost(rover, slope->soils(), g_mps2, 1);
      const SlopeDrive table = cost.soils[0].at(radians(slope_deg));
      EXPECT_EQ(table.energy_jpm, 0);
      const auto go = [&](double length_m) {
        return drive(rover, *slope, {{0, length_m * std::cos(radians(slope_deg))}}, 1);
      };
      const DriveResult far = go(60), near = go(30);
      ASSERT_EQ(far.failure + near.failure, "");
      const auto taken_j = [](const DriveResult& r) { return -r.work.motors_j - r.work.brakes_j; };
      const double taken_jpm = (taken_j(far) - taken_j(near)) / (far.distance_m - near.distance_m);
      const double spared_jpm = table.spare_jpm * rover_efficiency(rover) / rover.drive_calibration;
      const std::string what = fmt::format("{} {} deg: table {:.1f} J/m, driven {:.1f}", name,
                                           slope_deg, spared_jpm, taken_jpm);
      RecordProperty(fmt::format("{}_{}", name, slope_deg), what);
      EXPECT_NEAR(spared_jpm, taken_jpm, 0.03 * taken_jpm) << what;
    }
  }
}

// Motors that brake cover their own losses and feed nothing back: a steep descent takes the power
// of the controllers alone, a gentle one that lets them coast some of the losses.
TEST(DriveTableDownhill, costs_what_braking_costs_the_simulated_rover) {
  for (const char* name : {"SEV", "LRV"}) {
    for (const double slope_deg : {-2.0, -5.0, -10.0}) {
      const auto slope =
          ground({"Moon", PlaneSurface{0, radians(slope_deg), radians(180)}, "ApolloNominal"});
      const VehicleConfig rover = rover_on(name, *slope, "Moon");
      const double g_mps2 = gravity_mps2(*find_body("Moon"), start);
      const DriveCost cost = drive_cost(rover, slope->soils(), g_mps2, 1);
      const double level_jpm = metre_j(cost, cost.soils[0].at(0));
      const double table_jpm = metre_j(cost, cost.soils[0].at(radians(slope_deg)));
      const auto go = [&](double length_m) {
        return drive(rover, *slope, {{0, length_m * std::cos(radians(slope_deg))}}, 1);
      };
      const DriveResult far = go(60), near = go(30);
      ASSERT_EQ(far.failure + near.failure, "");
      const double driven_jpm = (far.drive_j - near.drive_j) / (far.distance_m - near.distance_m);
      const std::string what =
          fmt::format("{} {} deg: table {:.1f} J/m, driven {:.1f}, level {:.1f}", name, slope_deg,
                      table_jpm, driven_jpm, level_jpm);
      RecordProperty(fmt::format("{}_{}", name, slope_deg), what);
      EXPECT_NEAR(table_jpm, driven_jpm, 0.03 * level_jpm) << what;
    }
  }
}

// Spirit drove on five wheels for years, dragging the sixth, which costs the pull that drags it.
TEST(DriveTableOfSpirit, with_a_locked_wheel_costs_more_and_climbs_less) {
  const auto level = ground({"Mars", PlaneSurface{}, "MMS"});
  const double g_mps2 = gravity_mps2(*find_body("Mars"), start);
  const auto soil = [&](const char* configuration) {
    const VehicleConfig rover = rover_on("MER", *level, "Mars", configuration);
    return drive_cost(rover, level->soils(), g_mps2, 0.035).soils[0];
  };
  const SoilDrive whole = soil(""), lame = soil("RightFrontLocked");
  EXPECT_GT(lame.at(0).energy_jpm, 1.5 * whole.at(0).energy_jpm);
  EXPECT_GT(lame.at(0).slip, whole.at(0).slip);
  EXPECT_LT(lame.last_rad(), whole.last_rad());
}

}  // namespace
}  // namespace lsos::test
