// Each shipped rover stands and drives on level ground and on a slope of the body that it was
// made for.
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "planet/ellipsoid.h"
#include "script_fixture.h"
#include "unit/vehicle/wheel_loads.h"
#include "vehicle/vehicle.h"

namespace lsos {
namespace {

struct Shipped {
  std::string name;
  std::string body, soil;
  double mass_kg;
  std::size_t wheels;
  std::vector<std::string> configurations;
};

void PrintTo(const Shipped& rover, std::ostream* out) { *out << rover.name; }

const Geodetic start{0.1, 0.2, 0};

class ShippedRover : public ::testing::TestWithParam<Shipped> {
 protected:
  // A plane that falls to the south by `slope_rad`.
  std::unique_ptr<Ground> ground(double slope_rad) const {
    TerrainSpec spec;
    spec.layers = {PlaneSurface{0, slope_rad, radians(180)}};
    spec.soil = catalog_.load_soil(GetParam().soil);
    return std::make_unique<Ground>(spec, SiteFrame(body(), start), 0);
  }
  const Body& body() const { return *find_body(GetParam().body); }
  double g_mps2() const { return gravity_mps2(body(), start); }
  RoverSpec spec() const { return catalog_.load_rover(GetParam().name).spec; }
  VehicleConfig vehicle(const std::string& configuration = "") const {
    return make_vehicle(spec(), configuration, g_mps2());
  }

 private:
  Catalog catalog_{std::vector<std::string>{LSOS_SOURCE_DIR}};
};

// Drives north until `distance_m` is reached, or until the time is over that this takes at a fifth
// of the cruise speed (plus 5 s); returns the distance driven, m.
double drive(Vehicle& vehicle, double distance_m) {
  DriveCommand ahead;
  ahead.speed_mps = vehicle.config().cruise_speed_mps;
  ahead.is_braking = false;
  const double limit_s = 5 * distance_m / ahead.speed_mps + 5;
  for (SimTime t{}; seconds(t) < limit_s; t += exchange_period) {
    if (vehicle.distance_m() >= distance_m) break;
    vehicle.command(ahead);
    vehicle.advance(exchange_period);
  }
  return vehicle.distance_m();
}

TEST_P(ShippedRover, has_its_published_mass_and_wheels) {
  const VehicleConfig config = vehicle();
  EXPECT_NEAR(config.mass_kg(), GetParam().mass_kg, 1e-9);
  EXPECT_EQ(std::ranges::count_if(config.links, [](const auto& link) { return !!link.wheel; }),
            static_cast<std::ptrdiff_t>(GetParam().wheels));
  EXPECT_FALSE(config.assumptions.empty());
  std::vector<std::string> names;
  for (const RoverConfiguration& configuration : spec().configurations) {
    names.push_back(configuration.name);
  }
  EXPECT_EQ(names, GetParam().configurations);
}

TEST_P(ShippedRover, stands_level_on_level_ground_with_its_weight_on_its_wheels) {
  const auto level = ground(0);
  Vehicle rover(vehicle(), *level);
  ASSERT_EQ(rover.place(start, 0), "");
  test::settle(rover);
  const VehicleReport report = rover.report();
  EXPECT_NEAR(report.pitch_rad, 0, 1e-3);
  EXPECT_NEAR(report.roll_rad, 0, 1e-3);
  const double weight_n = rover.config().mass_kg() * g_mps2();
  const std::map<std::string, double> loads_n = test::wheel_loads_n(rover);
  EXPECT_NEAR(test::sum(loads_n), weight_n, 1e-3 * weight_n);
  const double mean_n = weight_n / static_cast<double>(loads_n.size());
  for (const auto& [name, load_n] : loads_n) {
    EXPECT_NEAR(load_n, mean_n, 0.1 * mean_n) << name;
    // The contact is stiff, but soft enough for the usual time steps.
    const double depth_m = load_n / rover.config().links.back().wheel->normal_stiffness_npm;
    EXPECT_LT(depth_m, 0.01) << name;
  }
}

TEST_P(ShippedRover, drives_ten_metres_straight) {
  const auto level = ground(0);
  Vehicle rover(vehicle(), *level);
  ASSERT_EQ(rover.place(start, 0), "");
  ASSERT_GE(drive(rover, 10), 10);
  const VehicleReport report = rover.report();
  EXPECT_NEAR(report.p_S_m.y(), rover.distance_m(), 0.05);
  EXPECT_NEAR(report.p_S_m.x(), 0, 0.05);
  EXPECT_GT(rover.drive_j(), 0);
  EXPECT_FALSE(report.is_chassis_on_ground);
}

TEST_P(ShippedRover, stands_on_ten_degrees_and_climbs_them) {
  const auto hill = ground(radians(10));
  Vehicle rover(vehicle(), *hill);
  ASSERT_EQ(rover.place(start, 0), "");
  const bool is_leveled = rover.config().posture.has_value();
  EXPECT_NEAR(rover.report().pitch_rad, is_leveled ? 0 : radians(10), radians(1));
  EXPECT_NEAR(rover.report().roll_rad, 0, radians(0.1));
  const double before_m = rover.report().p_S_m.z();
  test::settle(rover);
  EXPECT_NEAR(rover.report().p_S_m.z(), before_m, 1e-3);
  EXPECT_GE(drive(rover, 10), 10);
  EXPECT_NEAR(rover.report().p_S_m.z() - before_m, rover.distance_m() * std::sin(radians(10)), 0.1);
  EXPECT_NEAR(rover.report().p_S_m.x(), 0, 0.5);
}

TEST_P(ShippedRover, stands_and_drives_in_every_configuration) {
  const auto level = ground(0);
  for (const std::string& configuration : GetParam().configurations) {
    Vehicle rover(vehicle(configuration), *level);
    ASSERT_EQ(rover.place(start, 0), "") << configuration;
    // Loaded limbs take longer to come to rest than springs do.
    test::settle(rover);
    test::settle(rover);
    const double weight_n = rover.config().mass_kg() * g_mps2();
    EXPECT_NEAR(test::sum(test::wheel_loads_n(rover)), weight_n, 1e-3 * weight_n);
    // Rovers with seized wheels drive a short distance in a long time, as Spirit found.
    const bool is_seized = configuration.find("Locked") != std::string::npos;
    EXPECT_GT(drive(rover, 1), is_seized ? 0.01 : 0.1) << configuration;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rovers, ShippedRover,
    ::testing::Values(
        Shipped{"SEV", "Moon", "ApolloNominal", 4000, 12, {"Unloaded"}},
        Shipped{"LRV", "Moon", "ApolloNominal", 697, 4, {"OneCrew", "Empty"}},
        // A simulant of its planet's soil; in loose lunar soil 10 degrees stop its small wheels.
        Shipped{"MER", "Mars", "MMS", 180, 6, {"RightFrontLocked", "RightFrontAndRearLocked"}},
        Shipped{"ATHLETE",
                "Moon",
                "ApolloNominal",
                850,
                6,
                {"Drive", "Stow", "Tall", "Passive", "Loaded"}},
        Shipped{"MSL", "Mars", "MMS", 899, 6, {}},
        Shipped{"VIPER", "Moon", "ApolloNominal", 430, 4, {}},
        Shipped{"Rashid", "Moon", "ApolloNominal", 10, 4, {}},
        Shipped{"Husky", "Earth", "ApolloDense", 50, 4, {"FullPayload"}}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace lsos
