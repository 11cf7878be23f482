#include "power/battery.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace lsos {
namespace {

const BatterySpec spec{.capacity_j = 3.6e6,
                       .charge_efficiency = 0.95,
                       .discharge_efficiency = 0.9,
                       .charge_power_max_w = 800,
                       .discharge_power_max_w = 2000,
                       .reserve = 0.1};

double imbalance_w(const PowerFlows& f) {
  return f.solar_w + f.external_w - f.load_w - f.drive_w - f.loss_w - f.energy_rate_w;
}

TEST(PowerFlows, charge_with_what_is_left_and_lose_some_of_it) {
  const PowerFlows f = power_flows(spec, 1e6, {.solar_available_w = 500, .load_w = 100});
  EXPECT_EQ(f.solar_w, 500);
  EXPECT_NEAR(f.energy_rate_w, 0.95 * 400, 1e-12);
  EXPECT_NEAR(f.loss_w, 0.05 * 400, 1e-12);
  EXPECT_EQ(f.shed_w, 0);
}

TEST(PowerFlows, take_from_the_battery_what_is_missing_and_lose_some_more) {
  const PowerFlows f =
      power_flows(spec, 1e6, {.solar_available_w = 100, .load_w = 200, .drive_w = 800});
  EXPECT_NEAR(f.energy_rate_w, -900 / 0.9, 1e-12);
  EXPECT_NEAR(f.loss_w, 100, 1e-12);
  EXPECT_EQ(f.drive_w, 800);
}

TEST(PowerFlows, leave_at_the_panel_what_a_full_battery_does_not_take) {
  const PowerFlows f =
      power_flows(spec, spec.capacity_j, {.solar_available_w = 500, .load_w = 100});
  EXPECT_EQ(f.solar_w, 100);
  EXPECT_EQ(f.energy_rate_w, 0);
  const PowerFlows fed = power_flows(spec, spec.capacity_j,
                                     {.solar_available_w = 50, .external_w = 300, .load_w = 100});
  EXPECT_EQ(fed.solar_w, 0);
  EXPECT_EQ(fed.external_w, 100);
}

TEST(PowerFlows, keep_to_the_batterys_powers) {
  const PowerFlows in = power_flows(spec, 1e6, {.solar_available_w = 3000});
  EXPECT_EQ(in.solar_w, 800);
  const PowerFlows out = power_flows(spec, 1e6, {.load_w = 500, .drive_w = 2500});
  EXPECT_NEAR(out.energy_rate_w, -2000 / 0.9, 1e-9);
  EXPECT_EQ(out.shed_w, 1000);
  EXPECT_EQ(out.load_w, 0);
  EXPECT_EQ(out.drive_w, 2000);
}

TEST(PowerFlows, shed_loads_when_the_battery_is_empty) {
  const PowerFlows f = power_flows(spec, 0, {.solar_available_w = 60, .load_w = 100});
  EXPECT_EQ(f.load_w, 60);
  EXPECT_EQ(f.shed_w, 40);
  EXPECT_EQ(f.energy_rate_w, 0);
}

TEST(PowerFlows, close_whatever_is_asked) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> power(0, 3000), share(0, 1);
  for (int k = 0; k < 10000; ++k) {
    const double energy_j = k % 5 == 0 ? 0 : k % 5 == 1 ? spec.capacity_j : share(random) * 3e6;
    const PowerFlows f =
        power_flows(spec, energy_j, {power(random), power(random), power(random), power(random)});
    EXPECT_NEAR(imbalance_w(f), 0, 1e-9);
    EXPECT_GE(std::min({f.solar_w, f.external_w, f.load_w, f.drive_w, f.loss_w, f.shed_w}), -1e-9);
  }
}

// Second method: steps of one second, each with the flows at its beginning.
TEST(EnergyAccount, in_closed_form_is_that_of_small_steps) {
  const PowerDemand demands[] = {{.solar_available_w = 900, .load_w = 150},
                                 {.load_w = 150, .drive_w = 600},
                                 {.solar_available_w = 20, .external_w = 10, .load_w = 300}};
  for (const PowerDemand& demand : demands) {
    const EnergyAccount start{.energy_j = 1.2e6};
    EnergyAccount small = start;
    for (int s = 0; s < 20000; ++s) {
      const PowerFlows f = power_flows(spec, small.energy_j, demand);
      small.energy_j = std::clamp(small.energy_j + f.energy_rate_w, 0.0, spec.capacity_j);
      small.solar_j += f.solar_w;
      small.load_j += f.load_w;
      small.loss_j += f.loss_w;
    }
    const EnergyAccount closed = after(spec, start, demand, 20000);
    EXPECT_NEAR(closed.energy_j, small.energy_j, 1e-6);
    EXPECT_NEAR(closed.solar_j, small.solar_j, 1000);
    EXPECT_NEAR(closed.load_j, small.load_j, 1000);
    EXPECT_NEAR(closed.loss_j, small.loss_j, 1000);
  }
}

TEST(EnergyAccount, may_be_evaluated_in_any_parts) {
  const PowerDemand demand{.solar_available_w = 700, .load_w = 100};
  const EnergyAccount start{.energy_j = 3e6};
  const EnergyAccount once = after(spec, start, demand, 5000);
  EnergyAccount parts = start;
  for (int k = 0; k < 50; ++k) parts = after(spec, parts, demand, 100);
  EXPECT_NEAR(once.energy_j, parts.energy_j, 1e-6);
  EXPECT_NEAR(once.solar_j, parts.solar_j, 1e-6);
  EXPECT_EQ(once.energy_j, spec.capacity_j);
}

// 2.3 days of driving in steps of 0.1 s.
TEST(EnergyAccount, closes_to_a_billionth_of_what_flowed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> power(0, 1500);
  const EnergyAccount start{.energy_j = 2e6};
  EnergyAccount a = start;
  for (int k = 0; k < 2'000'000; ++k) {
    a = after(spec, a, {power(random), 0, 150, power(random)}, 0.1);
  }
  a = with_energy(a, 1e6);
  const double imbalance_j =
      a.energy_j - start.energy_j - (a.solar_j + a.external_j - a.load_j - a.drive_j - a.loss_j);
  EXPECT_LT(std::abs(imbalance_j), 1e-9 * (a.solar_j + a.load_j + a.drive_j));
}

}  // namespace
}  // namespace lsos
