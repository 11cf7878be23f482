#include "edit/plan_notes.h"

#include "edit_fixture.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kml =
    "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document><Style id=\"lsos-a\"/>"
    "<Folder><name>Estimate</name></Folder></Document></kml>";

TEST(PlanNotes, stand_where_kml_wants_them_and_leave_the_plan) {
  TestPlan plan(mission() + rover("A") + pause("a", "A", 10));
  put_notes(plan.document,
            {{&plan.event("A", 10), "<b>x</b>", "2026-07-01T00:00:00Z", "2026-07-01T00:10:00Z"}},
            kml);
  const std::string text = plan.document.text();
  EXPECT_THAT(text, HasSubstr("<name>a</name><description>&lt;!--lsos-estimate--&gt;&lt;b&gt;x"
                              "&lt;/b&gt;&lt;!--/lsos-estimate--&gt;</description><TimeSpan "
                              "id=\"lsos-time-1\"><begin>2026-07-01T00:00:00Z</begin><end>"
                              "2026-07-01T00:10:00Z</end></TimeSpan><ExtendedData>"));
  EXPECT_LT(text.find("<Style id=\"lsos-a\"/>"), text.find("<Placemark>"));
  EXPECT_THAT(text, HasSubstr("<Folder id=\"lsos-folder-1\"><name>Estimate</name></Folder>"));
  EXPECT_EQ(plan.edited().hash(), plan.plan.hash());
}

TEST(PlanNotes, take_the_place_of_earlier_ones_and_leave_what_is_a_planners) {
  const std::string mine =
      "<Placemark><name>a</name><description>mine<!-- kept --><![CDATA[ & <i>more</i>]]>"
      "</description><TimeSpan><begin>2026</begin></TimeSpan><ExtendedData><SchemaData "
      "schemaUrl=\"#Pause\"><SimpleData name=\"RoverId\">A</SimpleData><SimpleData "
      "name=\"Sequence\">10</SimpleData><SimpleData name=\"Duration\">10</SimpleData></SchemaData>"
      "</ExtendedData></Placemark>\n";
  const std::string folder = "<Folder><name>Estimate</name></Folder>\n";
  TestPlan plan(mission() + rover("A") + mine + folder, "<Style id=\"lsosish\"/>\n");
  put_notes(plan.document, {{&plan.event("A", 10), "earlier", "2026-07-01T00:00:00Z", ""}}, kml);
  put_notes(plan.document, {{&plan.event("A", 10), "new", "", ""}}, kml);
  const std::string text = plan.document.text();
  EXPECT_THAT(text, Not(HasSubstr("earlier")));
  EXPECT_THAT(text, HasSubstr("mine<!-- kept --><![CDATA[ & <i>more</i>]]>&lt;!--lsos-estimate--"
                              "&gt;new&lt;!--/lsos-estimate--&gt;</description><TimeSpan><begin>"
                              "2026</begin></TimeSpan>"));
  // Without notes nothing of them is left.
  put_notes(plan.document, {}, "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document/></kml>");
  EXPECT_EQ(canonical(plan.document.text()), canonical(plan.text));
}

TEST(PlanNotes, are_taken_away_whole) {
  TestPlan plan(mission() + rover("A") + pause("a", "A", 10));
  EXPECT_FALSE(erase_notes(plan.document));
  put_notes(plan.document,
            {{&plan.event("A", 10), "<b>x</b>", "2026-07-01T00:00:00Z", "2026-07-01T00:10:00Z"}},
            kml);
  EXPECT_TRUE(erase_notes(plan.document));
  EXPECT_EQ(canonical(plan.document.text()), canonical(plan.text));
}

}  // namespace
}  // namespace lsos::test
