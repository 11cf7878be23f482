// A plan that is a case of another: scripts and rasters lie beside that one.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "base/sha256.h"
#include "plan/kml_reader.h"
#include "support/test_folder.h"
#include "unit/plan/plan_fixture.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class CaseOf : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "out/cases/000001");
    std::ofstream(folder_ / "base.kml") << "a plan";
    std::ofstream(folder_ / "ground.tif") << "a raster";
  }

  Plan read(const Fields& fields) {
    faults_ = {};
    const std::string file = folder_ / "out/cases/000001/plan.kml";
    const std::string text = document(mission(fields) + rover("A"));
    return read_plan(file, parse_kml(text, file), declarations(), faults_);
  }

  const std::string digest_ = sha256_hex("a plan");
  const TestFolder own_;
  const fs::path folder_ = own_.path();
  Faults faults_;
};

TEST_F(CaseOf, names_the_plan_beside_which_rasters_lie) {
  const Plan plan = read({{"CaseOf", "../../../base.kml"},
                          {"CaseOfSha256", digest_},
                          {"TerrainBeyond", "ground.tif"}});
  EXPECT_FALSE(faults_.has_errors());
  EXPECT_TRUE(fs::equivalent(plan.home, folder_ / "base.kml"));
  EXPECT_TRUE(plan.mission.terrain_beyond.is_raster);
  EXPECT_TRUE(fs::equivalent(plan.mission.terrain_beyond.name, folder_ / "ground.tif"));
}

TEST_F(CaseOf, is_no_part_of_what_the_plan_says) {
  const std::string hash =
      read({{"CaseOf", "../../../base.kml"}, {"CaseOfSha256", digest_}}).hash();
  EXPECT_EQ(hash, read({}).hash());
  EXPECT_NE(hash, read({{"Soil", "Sand"}}).hash());
  EXPECT_NE(read({{"Soil", "Sand"}}).hash(), read({{"SoilVariant", "Sand"}}).hash());
}

TEST_F(CaseOf, must_name_a_plan_that_is_there) {
  read({{"CaseOf", "../../other.kml"}});
  ASSERT_TRUE(faults_.has_errors());
  EXPECT_THAT(to_string(faults_.sorted().front()),
              HasSubstr("MissionInfo: CaseOf = '../../other.kml': there is no plan "));
}

TEST_F(CaseOf, must_have_been_made_of_that_plan) {
  for (const std::string& digest : {std::string(), sha256_hex("another plan")}) {
    const Plan plan = read({{"CaseOf", "../../../base.kml"}, {"CaseOfSha256", digest}});
    ASSERT_TRUE(faults_.has_errors());
    EXPECT_THAT(to_string(faults_.sorted().front()),
                HasSubstr("base.kml is not the file of which this is a case, by its CaseOfSha256"));
    EXPECT_EQ(plan.home, plan.file) << "nothing beside the other plan is read";
  }
}

TEST_F(CaseOf, is_absent_from_other_plans) {
  const Plan plan = read({});
  EXPECT_EQ(plan.home, plan.file);
}

}  // namespace
}  // namespace lsos::test
