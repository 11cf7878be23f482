#include "vehicle/posture_control.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/vehicle/test_limbs.h"
#include "vehicle/limb_hindrance.h"
#include "vehicle/limb_stance.h"
#include "vehicle/vehicle.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

VehicleConfig posed_vehicle() { return make_vehicle(test::rover_on_limbs(), "", 1.6); }

double tilt_rad(Vehicle& posed_vehicle) {
  const VehicleReport report = posed_vehicle.report();
  return std::acos(std::cos(report.pitch_rad) * std::cos(report.roll_rad));
}

PostureControl::Input at_rest() {
  PostureControl::Input input;
  input.loads_n.assign(6, 200);
  input.angles_rad.assign(6, std::vector<double>(3, 0.0));
  input.is_fixed.assign(6, std::vector<bool>(3, false));
  return input;
}

TEST(PostureControl, turns_what_was_forced_out_of_its_range_back_at_the_rate_of_its_motor) {
  const VehicleConfig config = posed_vehicle();
  PostureControl control(config);
  PostureControl::Input input = at_rest();
  input.angles_rad[0][2] = 1.6;  // the range of limb_1_knee ends at 1.5
  const double rate_radps = control.rates_radps(input)[0][2];
  EXPECT_NEAR(rate_radps, -0.2, 1e-9);
}

TEST(PostureControl, a_move_has_its_target_from_its_beginning) {
  const VehicleConfig config = posed_vehicle();
  PostureControl control(config);
  const std::vector<Vec3> high = at_height(config, control.hubs_B_m(), 1.1);
  control.move_to(high, true, 10);
  EXPECT_EQ(control.target_hubs_B_m(), high);
  EXPECT_NE(control.hubs_B_m(), high);
}

// A downhill limb that is at its end keeps the chassis from standing as high, not from standing
// level.
TEST(PostureControl, gives_up_height_to_stay_level) {
  VehicleConfig config = posed_vehicle();
  const double wanted_m = height_range(config).greatest_m - 0.15;
  ASSERT_EQ(stand(config, at_height(config, hubs_B_m(config), wanted_m)), "");
  const auto ground = test::moon(0.2, 0);
  Vehicle v(config, *ground);
  ASSERT_EQ(v.place(ground->site().origin(), 0), "");
  EXPECT_LT(tilt_rad(v), 0.02);
  EXPECT_FALSE(v.is_adjusting());
  // The hubs are 1.7 m ahead and behind: the lower ones lack 0.2 x 1.7 m less what was left.
  EXPECT_NEAR(height_m(config, v.hubs_B_m()), wanted_m + 0.15 - 0.2 * 1.73, 0.08);
  EXPECT_THAT(stance_fault(v), HasSubstr("its chassis is "));
  // It stays so: nothing swings or sinks.
  double worst_rad = 0;
  v.command({.speed_mps = 0.3, .is_braking = false});
  for (int i = 0; i < 300; ++i) {
    v.advance(exchange_period);
    worst_rad = std::max(worst_rad, tilt_rad(v));
  }
  EXPECT_LT(worst_rad, 0.05);
  EXPECT_NEAR(height_m(config, v.hubs_B_m()), wanted_m + 0.15 - 0.2 * 1.73, 0.12);
}

}  // namespace
}  // namespace lsos
