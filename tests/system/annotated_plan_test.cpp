// `lsos-host check --kml`: the plan with its estimate, for viewers.

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/replaced.h"
#include "support/reference_data.h"
#include "system/kml_file.h"
#include "system/plan_text.h"
#include "system/process.h"
#include "system/source_files.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

nlohmann::json checked(const std::string& file) {
  const Outcome outcome = run({"check", file, "--json", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return nlohmann::json::parse(outcome.out);
}

class AnnotatedPlan : public ::testing::Test {
 protected:
  // The text of the plan with its estimate.
  std::string annotated(const std::string& file) const {
    const Outcome outcome = run({"check", file, "--kml", annotated_, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
    return read_text(annotated_);
  }

  TempFolder folder_;
  std::string annotated_ = folder_ / "annotated.kml";
};

TEST_F(AnnotatedPlan, is_the_same_plan_and_valid) {
  for (const char* name : {"two_rovers", "solar_stop", "first_drive"}) {
    const std::string text = annotated(plan(name));
    EXPECT_EQ(checked(annotated_).at("plan_sha256"), checked(plan(name)).at("plan_sha256")) << name;
    // Nothing that was there is gone.
    const Outcome gone = run_command({"diff", "--unchanged-line-format=", "--old-line-format=-%L",
                                      "--new-line-format=", plan(name), annotated_});
    EXPECT_EQ(gone.out, "") << name;
    LSOS_NEEDS_REFERENCE("kml/xsd");
    const Outcome valid = run_command(
        {"xmllint", "--nonet", "--noout", "--schema", "ogckml22.xsd", annotated_},
        {.folder = reference_file("kml/xsd"), .environment = {"XML_CATALOG_FILES=catalog.xml"}});
    EXPECT_EQ(valid.exit_code, 0) << name << valid.err;
  }
}

TEST_F(AnnotatedPlan, is_annotated_again_in_place_of_before) {
  const std::string once = folder_.write("once.kml", annotated(plan("two_rovers")));
  EXPECT_EQ(annotated(once), read_text(once));
  // After an edit it tells of the new plan, and only of that.
  const std::string off = folder_ / "off.kml";
  ASSERT_EQ(run({"edit", once, "disable", "--type", "EVA", "-o", off}).exit_code, 0);
  const std::string changed = annotated(off);
  EXPECT_THAT(read_text(once), HasSubstr(" EVA "));
  EXPECT_THAT(changed, Not(ContainsRegex("<name>[^<]*#[0-9]+ EVA ")));
  EXPECT_THAT(changed, HasSubstr("It is disabled."));
}

TEST_F(AnnotatedPlan, tells_of_each_event) {
  std::string text = kml({mission(), sev("A", "0,0"),
                          event("Route", "A", 10, {{"Speed", "2"}}, line("0,0 0.01,0")),
                          event("Pause", "A", 20, {{"Duration", "1 h"}}),
                          event("Pause", "A", 30, {{"Duration", "30 h"}}),
                          event("Pause", "A", 40, {{"Duration", "60"}, {"Timeout", "20"}})});
  text = replaced(text, "<Placemark><ExtendedData><SchemaData schemaUrl=\"#Route\">",
                  "<Placemark><name>out</name><description><![CDATA[<b>mine</b>]]></description>"
                  "<TimeStamp><when>2026</when></TimeStamp><ExtendedData><SchemaData "
                  "schemaUrl=\"#Route\">");
  const std::string marked = annotated(folder_.write("plan.kml", text));
  EXPECT_THAT(marked, HasSubstr("<description><![CDATA[<b>mine</b>]]>&lt;!--lsos-estimate--&gt;"
                                "&lt;h4&gt;Estimate"));
  EXPECT_THAT(marked, HasSubstr("&lt;td&gt;Drives&lt;td&gt;303 m"));
  EXPECT_THAT(marked, HasSubstr("<TimeStamp><when>2026</when></TimeStamp><ExtendedData>"))
      << "its own time stays";
  EXPECT_THAT(marked, ContainsRegex("<TimeSpan id=\"lsos-time-2\"><begin>2026-01-01T00:0[0-9:.]+Z"
                                    "</begin><end>2026-01-01T01:0[0-9:.]+Z</end></TimeSpan>"));
  EXPECT_THAT(marked, HasSubstr("<Folder id=\"lsos-folder-1\">"));
  EXPECT_THAT(marked, HasSubstr("<name>Day 1, 2026-01-01</name>"));
  EXPECT_THAT(marked, HasSubstr("<name>Day 2, 2026-01-02</name>"));
  EXPECT_THAT(marked, ContainsRegex("<name>#20 Pause 01:0[0-9] [0-9]+ %</name>"));
  EXPECT_THAT(marked, ContainsRegex("<name>#40 Pause [0-9:]+ [0-9]+ % fails</name>"));
  EXPECT_THAT(marked, HasSubstr("#lsos-fails"));
  EXPECT_THAT(marked, HasSubstr("&lt;b&gt;Warning:&lt;/b&gt; "));
  EXPECT_THAT(marked, HasSubstr("<name>Lines by charge</name>"));
}

TEST_F(AnnotatedPlan, is_no_plan_with_faults_and_no_other_file) {
  const std::string wrong = folder_.write(
      "wrong.kml", kml({mission(), sev("A", "0,0"), event("Pause", "A", 10, {{"Duratoin", "1"}})}));
  EXPECT_EQ(run({"check", wrong, "--kml", annotated_}).exit_code, 2);
  EXPECT_FALSE(fs::exists(annotated_));
  const std::string right = folder_.write("right.kml", kml(short_drive()));
  const Outcome over = run({"check", right, "--kml", right});
  EXPECT_EQ(over.exit_code, 2);
  EXPECT_EQ(read_text(right), kml(short_drive()));
}

}  // namespace
}  // namespace lsos::test
