// The single-wheel test bed on the command line, as an engineer uses it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json rig(const Words& options) {
  Words words{"rig", "--radius", "0.0625", "--width", "0.06", "--load", "24"};
  words.insert(words.end(), options.begin(), options.end());
  const Outcome outcome = run(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out);
}

TEST(Rig, answers_a_point_for_each_slip_with_the_fields_of_the_contract) {
  const json points = rig({"--soil", "DrySand", "--slip", "-0.5,0,0.5"});
  ASSERT_EQ(points.size(), 3u);
  for (const json& point : points) {
    for (const char* key : {"slip", "drawbar_pull_n", "side_force_n", "torque_n_m", "sinkage_m",
                            "traction_limit_n", "rolling_radius_m"}) {
      EXPECT_TRUE(point[key].is_number()) << key;
    }
    EXPECT_EQ(point["side_force_n"], 0);
  }
  EXPECT_EQ(points[0]["slip"], -0.5);
  EXPECT_LT(points[0]["drawbar_pull_n"], points[1]["drawbar_pull_n"]);
  EXPECT_LT(points[1]["drawbar_pull_n"], points[2]["drawbar_pull_n"]);
  EXPECT_LT(points[1]["sinkage_m"], points[2]["sinkage_m"]);
  EXPECT_LT(points[0]["torque_n_m"], 0);
  EXPECT_GT(points[2]["torque_n_m"], 0);
}

TEST(Rig, pushes_back_a_wheel_that_slides_to_its_left) {
  EXPECT_LT(rig({"--soil", "DrySand", "--slip", "0", "--slip-angle", "30"})[0]["side_force_n"], 0);
  EXPECT_GT(rig({"--soil", "DrySand", "--slip", "0", "--slip-angle", "-30"})[0]["side_force_n"], 0);
}

TEST(Rig, grousers_pull_more_and_lower_gravity_bears_less) {
  const auto pull = [](const Words& more) {
    Words words{"--soil", "DrySand", "--slip", "0.5"};
    words.insert(words.end(), more.begin(), more.end());
    return rig(words)[0]["drawbar_pull_n"].get<double>();
  };
  EXPECT_GT(pull({"--grouser-height", "0.006", "--grouser-count", "15"}), pull({}) + 1);
  const TempFolder folder;
  const std::string sand =
      folder.write("sand.lua",
                   "return { cohesion_pa = 0, friction_rad = 0.55, density_kgpm3 = 1600, "
                   "shear_modulus_x_m = 0.01, shear_modulus_y_m = 0.01 }");
  const auto sinkage = [&](const char* gravity) {
    return rig({"--soil", sand, "--slip", "0", "--gravity", gravity})[0]["sinkage_m"].get<double>();
  };
  // Soil of less weight has less bearing capacity (Terzaghi's law).
  EXPECT_GT(sinkage("1.62"), 2 * sinkage("9.80665"));
}

TEST(Rig, counts_slip_by_the_rolling_radius_or_by_the_rim) {
  const Words lugs{"--soil",          "DrySand", "--grouser-height", "0.006",
                   "--grouser-count", "15",      "--slip",           "0"};
  const auto at_zero = [&](const Words& more) {
    Words words = lugs;
    words.insert(words.end(), more.begin(), more.end());
    return rig(words)[0];
  };
  const json rolling = at_zero({}), rim = at_zero({"--rim-slip"});
  // The soil between the grousers turns with the wheel: it drives at a rim that does not slip.
  // Soil sheared by the curved rim carries the wheel a little further than that.
  EXPECT_GT(rolling["rolling_radius_m"], 0.0625);
  EXPECT_LT(rolling["rolling_radius_m"], 1.25 * (0.0625 + 0.006));
  EXPECT_EQ(rolling["slip"], 0);
  EXPECT_NEAR(rolling["torque_n_m"], 0, 1e-9);
  EXPECT_LT(rolling["drawbar_pull_n"], 0);
  EXPECT_EQ(rim["slip"], 0);
  EXPECT_GT(rim["drawbar_pull_n"], rolling["drawbar_pull_n"]);
}

TEST(Rig, doubts_a_pull_that_no_wheel_was_measured_to_have) {
  const TempFolder folder;
  const std::string clay = folder.write(
      "clay.lua",
      "return { k_c = 13e3, k_phi = 692e3, n = 0.5, cohesion_pa = 20e3, friction_rad = "
      "0.6, density_kgpm3 = 1600, shear_modulus_x_m = 0.005 }");
  const Outcome outcome =
      run({"rig", "--soil", clay, "--radius", "0.1", "--width", "0.1", "--load", "20", "--slip",
           "0.8", "--grouser-height", "0.015", "--grouser-count", "14"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("no measured wheel has pulled more than 0.8"));
}

TEST(Rig, a_soft_carcass_sinks_less_and_pulls_more) {
  const json rigid = rig({"--soil", "DrySand", "--slip", "0.2"})[0];
  const json soft = rig({"--soil", "DrySand", "--slip", "0.2", "--carcass", "4000"})[0];
  EXPECT_LT(soft["sinkage_m"], rigid["sinkage_m"]);
  EXPECT_GT(soft["drawbar_pull_n"], rigid["drawbar_pull_n"]);
  const Outcome flat = run({"rig", "--soil", "DrySand", "--radius", "0.1", "--width", "0.1",
                            "--load", "10", "--slip", "0", "--carcass", "100"});
  EXPECT_EQ(flat.exit_code, 2);
  EXPECT_THAT(flat.err, HasSubstr("--carcass 100: must be so great that"));
}

TEST(Rig, takes_a_table_or_what_lsos_soil_makes) {
  const TempFolder folder;
  const std::string keys =
      "{ k_c = 990, k_phi = 1528430, n = 1.1, cohesion_pa = 1040, friction_rad = math.rad(28), "
      "density_kgpm3 = 1600, shear_modulus_x_m = 0.015, shear_modulus_y_m = 0.015 }";
  const std::string plain = folder.write("plain.lua", "return " + keys);
  const std::string made =
      folder.write("made.lua", "local lsos = require 'lsos'\nreturn lsos.soil " + keys);
  const json by_name = rig({"--soil", "DrySand", "--slip", "0.3"});
  EXPECT_EQ(rig({"--soil", plain, "--slip", "0.3"}), by_name);
  EXPECT_EQ(rig({"--soil", made, "--slip", "0.3"}), by_name);
}

TEST(Rig, says_where_a_soil_file_is_wrong) {
  const TempFolder folder;
  const auto error = [&](const char* text) {
    const Outcome outcome = run({"rig", "--soil", folder.write("soil.lua", text), "--radius", "0.1",
                                 "--width", "0.1", "--load", "10", "--slip", "0"});
    EXPECT_EQ(outcome.exit_code, 2);
    return outcome.err;
  };
  EXPECT_THAT(error("return { cohesion = 1 }"), HasSubstr("did you mean 'cohesion_pa'?"));
  EXPECT_THAT(error("return 3"), HasSubstr("must return a soil, a table {...} or lsos.soil {...}"));
  EXPECT_THAT(error("return {"), HasSubstr("soil.lua:1"));
}

}  // namespace
}  // namespace lsos::test
