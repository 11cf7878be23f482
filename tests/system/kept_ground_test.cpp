// Generated ground is laid out about a mission's site: edits leave it where it was, though another
// rover is the first then or the first starts elsewhere.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

Mark mission_on(const std::string& terrain, const Fields& more = {}) {
  Mark info = mission();
  for (auto& [name, value] : info.fields) {
    if (name == "Terrain") value = terrain;
  }
  info.fields.insert(info.fields.end(), more.begin(), more.end());
  return info;
}

// The middle of a value of an estimate, which may be a range.
double middle(const json& value) {
  if (value.is_number()) return value;
  return (double(value["low"]) + double(value["high"])) / 2;
}

class KeptGround : public ::testing::Test {
 protected:
  std::string with_rover(const std::string& terrain, const std::string& id,
                         const std::string& at) const {
    return folder_.write(
        terrain + id + ".kml",
        kml({mission_on(terrain), sev(id, at), event("Pause", id, 10, {{"Duration", "60"}})}));
  }
  Outcome edit(const std::string& plan, const Words& how) const {
    Words words{"edit", plan};
    words.insert(words.end(), how.begin(), how.end());
    words.insert(words.end(), {"-o", new_plan_, "--force"});
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome;
  }
  static json checked(const std::string& plan) {
    const Outcome outcome = run({"check", plan, "--json", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    return json::parse(outcome.out);
  }

  TempFolder folder_;
  std::string new_plan_ = folder_ / "new.kml";
};

TEST_F(KeptGround, of_a_day_that_is_split_off) {
  const std::string at = "-148.9612345678901,12.0201234567891";
  const std::string whole = folder_.write(
      "whole.kml", kml({mission_on("Craters"), sev("A", at),
                        event("Route", "A", 10, {}, line(at + " -148.95,12.02")),
                        event("Pause", "A", 20, {{"Duration", "12 h"}}),
                        event("Route", "A", 40, {{"StartTime", "2026-01-02T06:00:00Z"}},
                              line("-148.95,12.02 -148.945,12.025"))}));
  EXPECT_THAT(edit(whole, {"split", "--day", "2"}).out,
              HasSubstr("; SiteOrigin = " + at + " keeps the ground where it was; wrote"));
  const json in_whole = checked(whole)["estimate"].back(), alone = checked(new_plan_)["estimate"];
  ASSERT_EQ(alone.size(), 1u);
  for (const char* name : {"energy_used_j", "distance_m"}) {
    EXPECT_NEAR(middle(alone[0][name]) / middle(in_whole[name]), 1, 1e-3) << name;
  }
}

TEST_F(KeptGround, of_the_plan_that_takes_up_another) {
  const std::string plan = with_rover("Craters", "A", "0,0");
  const Outcome outcome = edit(plan, {"merge", with_rover("Craters", "01", "0.01,0")});
  EXPECT_THAT(outcome.out, HasSubstr("; SiteOrigin = 0,0 keeps the ground where it was"));
  EXPECT_THAT(outcome.err,
              HasSubstr("Craters01.kml: the ground of Craters was laid out from 0.01,0, and is "
                        "from 0,0 now, 303 m away, as in " +
                        plan));
  edit(plan, {"merge", with_rover("Craters", "B", "0.01,0")});
  EXPECT_THAT(read_text(new_plan_), Not(HasSubstr("SiteOrigin"))) << "A is the first as before";
}

TEST_F(KeptGround, needs_no_word_where_the_ground_is_even) {
  const Outcome outcome =
      edit(with_rover("Flat", "A", "0,0"), {"merge", with_rover("Flat", "01", "0.01,0")});
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(read_text(new_plan_), Not(HasSubstr("SiteOrigin")));
}

TEST_F(KeptGround, of_a_plan_that_a_sheet_changes) {
  const std::string plan = with_rover("Craters", "A", "0,0");
  const std::string sheet = folder_.write("more.csv",
                                          "Type,Rover,Sequence,RoverType,Lon,Lat,Duration\nRover,"
                                          "01,,SEV,0.01,0,\nPause,01,10,,,,60\nPause,A,10,,,,60\n");
  const Outcome outcome = run({"import", sheet, "--onto", plan, "-o", new_plan_});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("SiteOrigin = 0,0 keeps the ground where it was"));
  EXPECT_THAT(read_text(new_plan_), HasSubstr("name=\"SiteOrigin\">0,0<"));
}

TEST_F(KeptGround, of_a_tilted_plane) {
  const Outcome outcome =
      edit(with_rover("Slope", "A", "0,0"), {"merge", with_rover("Slope", "01", "0.01,0")});
  EXPECT_THAT(outcome.out, HasSubstr("; SiteOrigin = 0,0 keeps the ground where it was"));
}

TEST_F(KeptGround, goes_with_the_rover_where_a_sheet_takes_its_site_away) {
  const std::string plan = folder_.write(
      "plan.kml", kml({mission_on("Craters", {{"SiteOrigin", "0.001,0"}}), sev("A", "0,0"),
                       event("Pause", "A", 10, {{"Duration", "60"}})}));
  const std::string sheet = folder_.write(
      "sheet.csv", "Type,Rover,Sequence,SiteOrigin,Duration\nMissionInfo,,,,\nPause,A,10,,60\n");
  const Outcome outcome = run({"import", sheet, "--onto", plan, "-o", new_plan_});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("without SiteOrigin generated ground is laid out from where "
                                     "the first rover starts"));
  EXPECT_THAT(read_text(new_plan_), Not(HasSubstr(">0.001,0<")));
}

TEST_F(KeptGround, has_its_site_in_every_format) {
  const std::string plan = folder_.write(
      "plan.kml", kml({mission_on("Craters", {{"SiteOrigin", "30.9612345678901,-19.5"}}),
                       sev("A", "30.96,-19.5"), event("Pause", "A", 10, {{"Duration", "60"}})}));
  const json sha256 = checked(plan)["plan_sha256"];
  for (const char* ending : {".csv", ".xlsx", ".ods", ".gpkg", ".geojson", ".txt"}) {
    const std::string file = folder_ / ("plan" + std::string(ending));
    ASSERT_EQ(run({"export", plan, "-o", file}).exit_code, 0) << ending;
    const Outcome outcome = run({"import", file, "-o", new_plan_, "--force"});
    ASSERT_EQ(outcome.exit_code, 0) << ending << outcome.err;
    EXPECT_EQ(checked(new_plan_)["plan_sha256"], sha256) << ending;
  }
}

}  // namespace
}  // namespace lsos::test
