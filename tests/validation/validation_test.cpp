// The report in the tree must equal what the program writes today, and the aims that the model has
// reached must stay reached.

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

#include "support/reference_data.h"
#include "validation/report.h"

namespace lsos::validation {
namespace {

class Validation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (std::filesystem::is_directory(data_folder())) cases_ = fit_all(data_folder());
  }
  void SetUp() override { LSOS_NEEDS_REFERENCE("terramech"); }

  static Errors straight(const Case& c) { return errors_of(c, c.fit.soil, c.straight); }

  static inline std::optional<Cases> cases_;
};

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

TEST_F(Validation, the_report_in_the_tree_is_what_the_program_writes) {
  const std::filesystem::path root = LSOS_SOURCE_DIR;
  const Files files = report(*cases_);
  std::set<std::string> names;
  for (const auto& [path, text] : files) {
    names.insert(std::filesystem::path(path).filename().string());
    EXPECT_TRUE(read(root / path) == text) << path << " is out of date: run write_validation";
    EXPECT_LT(text.size(), 60'000u) << path;
  }
  for (const auto& entry : std::filesystem::directory_iterator(root / "core/vehicle/validation")) {
    EXPECT_TRUE(names.contains(entry.path().filename().string()))
        << entry.path() << " is not of this program";
  }
}

TEST_F(Validation, reads_each_trial_of_the_cmu_rig_once) {
  // 7 slip angles x 9 slips; counts and a mean that the file's description states.
  EXPECT_EQ(cases_->cmu.tests.points.size(), 63u);
  int trials = 0;
  for (const MeasuredPoint& m : cases_->cmu.tests.points) trials += m.repeats;
  EXPECT_EQ(trials, 190);
  const MeasuredPoint& half = cases_->cmu.straight[5];
  EXPECT_NEAR(half.slip, 0.50, 0.005);
  EXPECT_NEAR(half.drawbar_pull_n / half.load_n, 0.038, 0.0005);
  EXPECT_NEAR(half.sinkage_m, 0.0224, 0.00005);
}

TEST_F(Validation, fits_stay_inside_their_bounds) {
  for (const Case* c : {&cases_->cmu, &cases_->ding, &cases_->kls}) {
    for (std::size_t i = 0; i < c->parameters.size(); ++i) {
      const FitParameter& p = c->parameters[i];
      EXPECT_GE(c->fit.values[i], p.low - 1e-9) << c->name << ": " << p.name;
      EXPECT_LE(c->fit.values[i], p.high + 1e-9) << c->name << ": " << p.name;
    }
  }
}

TEST_F(Validation, a_fit_is_never_worse_than_the_published_soil) {
  for (const Case* c : {&cases_->cmu, &cases_->ding, &cases_->kls}) {
    EXPECT_LE(straight(*c).sinkage_typical,
              errors_of(*c, c->published, c->straight).sinkage_typical)
        << c->name;
  }
}

TEST_F(Validation, pull_of_a_straight_wheel_is_within_a_tenth_of_its_load) {
  EXPECT_LE(straight(cases_->cmu).pull, pull_aim);
  EXPECT_LE(straight(cases_->ding).pull, pull_aim);
  EXPECT_LE(straight(cases_->kls).pull, pull_aim);
}

TEST_F(Validation, sinkage_of_a_straight_wheel_is_within_half_again) {
  EXPECT_LE(straight(cases_->cmu).sinkage_worst, sinkage_aim);
  EXPECT_LE(straight(cases_->ding).sinkage_worst, sinkage_aim);
  // KLS-1 misses the aim at slip 0.1, where 1 mm was measured; see the report.
  const std::vector<MeasuredPoint> deeper(cases_->kls.straight.begin() + 1,
                                          cases_->kls.straight.end());
  EXPECT_LE(errors_of(cases_->kls, cases_->kls.fit.soil, deeper).sinkage_worst, sinkage_aim);
}

TEST_F(Validation, forces_at_slip_angles_to_45_degrees_are_predicted) {
  const std::vector<MeasuredPoint> turned = rolling_at(cases_->cmu.tests, {15, 30, 45});
  ASSERT_EQ(turned.size(), 24u);
  const Errors e = errors_of(cases_->cmu, cases_->cmu.fit.soil, turned);
  EXPECT_LE(e.pull, turned_pull_aim);
  EXPECT_LE(e.side, turned_side_aim);
}

// The measured wheel (CMU) sinks as deep at slip -0.2 as at 0, within 5 %.
TEST_F(Validation, sinkage_grows_with_slip_and_is_least_where_a_braked_wheel_rolls_freely) {
  for (const Case* c : {&cases_->cmu, &cases_->ding, &cases_->kls}) {
    const SinkageGrowth growth = sinkage_growth(*c);
    EXPECT_TRUE(growth.grows_driven) << c->name;
    EXPECT_GE(growth.least_at_slip, -0.2) << c->name;
    EXPECT_LT(growth.least_at_slip, 0) << c->name;
    EXPECT_GE(growth.at_least_m, 0.75 * growth.at_zero_m) << c->name;
  }
}

TEST_F(Validation, the_report_names_the_aims_that_are_missed) {
  std::vector<std::string> missed;
  for (const Aim& aim : aims(*cases_)) {
    if (!aim.is_reached) missed.push_back(aim.what);
  }
  EXPECT_THAT(missed, testing::ElementsAre("KLS-1: straight, sinkage at each point",
                                           "CMU sand: sinkage grows with slip",
                                           "Ding 2011: sinkage grows with slip",
                                           "KLS-1: sinkage grows with slip"));
}

}  // namespace
}  // namespace lsos::validation
