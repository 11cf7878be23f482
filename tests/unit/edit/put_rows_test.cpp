#include "edit/put_rows.h"

#include "base/error.h"
#include "edit/placemark_edit.h"
#include "unit/edit/edit_fixture.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// A row with these fields, as import_tables() makes it.
SourcePlacemark row(const std::string& type, const std::string& name, const Fields& fields,
                    const SourceGeometry& geometry = {}) {
  SourcePlacemark made;
  made.file = "sheet.csv";
  made.name = name;
  made.data.push_back({"", type, {}});
  for (const auto& [field, text] : fields) made.data.front().fields.push_back({field, text});
  if (!geometry.kind.empty()) made.geometries.push_back(geometry);
  return made;
}

// The things of a test's plan, each with one SchemaData.
KmlSource things_of(const TestPlan& plan) {
  KmlSource things = parse_kml(plan.text, "plan.kml");
  std::erase_if(things.placemarks, [](const SourcePlacemark& each) { return each.data.empty(); });
  return things;
}

class PutRows : public ::testing::Test {
 protected:
  RowChanges put(TestPlan& plan, const std::vector<SourcePlacemark>& rows,
                 const SheetColumns& columns, bool removes = false) {
    RowChanges changes = row_changes(things_of(plan), rows, {{"sheet.csv", columns}}, plan.known);
    const std::vector<ThingKey> gone = removes ? removable(changes, rows) : std::vector<ThingKey>{};
    leave_out(changes, gone);
    put_rows(plan.document, changes, gone);
    Faults none;
    EXPECT_EQ(plan.edited().hash(), read_plan("plan.kml", changes.merged, plan.known, none).hash());
    EXPECT_FALSE(none.has_errors());
    return changes;
  }
  SheetColumns all_{{"RoverId", "Sequence", "Speed", "Duration", "name", "description"}, true};
};

TEST_F(PutRows, what_means_the_same_is_no_change) {
  TestPlan plan(mission() + rover("A") +
                event("Route", "a", "A", 10, {{"Speed", "3.6 km/h"}},
                      line("\n  31.0,20,5\n  31.10,20.2,6\n")) +
                pause("b  c", "A", 20));
  const RowChanges changes =
      put(plan,
          {row("Route", "a", {{"RoverId", "A"}, {"Sequence", "10"}, {"Speed", "1"}},
               {"LineString", "31,20 31.1,20.2"}),
           row("Pause", "b c", {{"RoverId", "A"}, {"Sequence", "20"}, {"Duration", "PT10S"}})},
          all_);
  EXPECT_EQ(changes.unchanged, 2u);
  EXPECT_THAT(changes.changed, IsEmpty());
  EXPECT_EQ(plan.document.text(), plan.text);
}

TEST_F(PutRows, an_empty_cell_takes_away_and_a_missing_column_leaves) {
  const std::string route =
      event("Route", "a", "A", 10, {{"Speed", "2"}, {"ArrivalRadius", "3"}}, point());
  const std::vector<SourcePlacemark> rows{row("Route", "", {{"RoverId", "A"}, {"Sequence", "10"}})};
  TestPlan kept(mission() + rover("A") + route);
  put(kept, rows, {{"RoverId", "Sequence"}, false});
  EXPECT_EQ(kept.document.text(), kept.text);
  TestPlan plan(mission() + rover("A") + route);
  const RowChanges changes = put(plan, rows, {{"RoverId", "Sequence", "Speed", "name"}, false});
  ASSERT_EQ(changes.changed.size(), 1u);
  EXPECT_THAT(changes.changed.front().fields, ElementsAre("Speed"));
  EXPECT_TRUE(changes.changed.front().has_new_name);
  EXPECT_THAT(plan.document.text(), Not(HasSubstr("<name>")));
  EXPECT_THAT(plan.document.text(), Not(HasSubstr("Speed")));
  EXPECT_THAT(plan.document.text(), HasSubstr("ArrivalRadius"));
}

TEST_F(PutRows, places_that_stay_keep_their_text) {
  TestPlan plan(mission() + rover("A") +
                event("Route", "a", "A", 10, {}, line("\n  31.00,20,5\n  31.1,20.2,6\n")));
  put(plan,
      {row("Route", "a", {{"RoverId", "A"}, {"Sequence", "10"}},
           {"LineString", "31,20 31.2,20.2 31.3,20"})},
      all_);
  EXPECT_EQ(plan.document.text(), replaced(plan.text, "31.1,20.2,6\n", "31.2,20.2\n  31.3,20\n"));
}

TEST_F(PutRows, a_line_may_become_a_point_and_nothing) {
  TestPlan plan(mission() + rover("A") + event("Route", "a", "A", 10, {}, line()) +
                event("Pause", "b", "A", 20, {{"Duration", "10"}}, point()));
  put(plan,
      {row("Route", "a", {{"RoverId", "A"}, {"Sequence", "10"}}, {"Point", "31.5,20"}),
       row("Pause", "b", {{"RoverId", "A"}, {"Sequence", "20"}, {"Duration", "10"}})},
      all_);
  const Plan edited = plan.edited();
  EXPECT_EQ(edited.events[0].geometry.kind, GeometryKind::point);
  EXPECT_EQ(edited.events[1].geometry.kind, GeometryKind::none);
}

TEST_F(PutRows, an_event_may_become_one_of_another_type) {
  TestPlan plan(
      mission() + rover("A") +
          placemark("a", "#Route",
                    {{"Type", "Route"}, {"RoverId", "A"}, {"Sequence", "10"}, {"Speed", "2"}},
                    point()),
      "<Schema id=\"Route\" name=\"Route\"><SimpleField name=\"RoverId\"/>"
      "<SimpleField name=\"Speed\"/></Schema>\n");
  put(plan,
      {row("Pause", "a", {{"RoverId", "A"}, {"Sequence", "10"}, {"Duration", "60"}},
           {"Point", "31,20"})},
      all_);
  const std::string text = plan.document.text();
  EXPECT_THAT(listed_events(plan.edited()), ElementsAre("A/10 Pause 'a'"));
  EXPECT_THAT(text, HasSubstr("<Schema name=\"Pause\" id=\"Pause\"><SimpleField name=\"RoverId\"/>"
                              "<SimpleField type=\"string\" name=\"Duration\"/></Schema>"));
  EXPECT_THAT(text, HasSubstr("name=\"Type\">Pause<"));
  EXPECT_THAT(text, HasSubstr("<SimpleField name=\"Speed\"/>")) << "that of Route stays";
}

TEST_F(PutRows, new_rows_lie_in_the_folder_of_the_day_or_of_their_type) {
  const auto folder = [](const std::string& in) { return "<Folder>\n" + in + "</Folder>\n"; };
  const std::vector<SourcePlacemark> rows{
      row("Pause", "new", {{"RoverId", "A"}, {"Sequence", "25"}, {"Duration", "60"}})};
  TestPlan days(mission() + rover("A") +
                folder(event("Route", "a", "A", 10, {}, point()) + pause("b", "A", 15)) +
                folder(event("Route", "c", "A", 20, {}, point()) + pause("d", "A", 30)));
  put(days, rows, all_);
  const std::string by_days = days.document.text();
  EXPECT_GT(by_days.find("new"), by_days.find("<name>c<"));
  EXPECT_LT(by_days.find("new"), by_days.find("<name>d<"));
  TestPlan types(mission() + rover("A") +
                 folder(event("Route", "a", "A", 10, {}, point()) +
                        event("Route", "c", "A", 20, {}, point())) +
                 folder(pause("b", "A", 15) + pause("d", "A", 30)));
  put(types, rows, all_);
  const std::string by_types = types.document.text();
  EXPECT_GT(by_types.find("new"), by_types.find("<name>b<"));
  EXPECT_LT(by_types.find("new"), by_types.find("<name>d<"));
}

TEST_F(PutRows, a_new_row_takes_the_style_of_its_kin_and_none_of_their_words) {
  TestPlan plan(mission() + rover("A") +
                "<Placemark><name>a</name><Snippet>s</Snippet><description>mine</description>"
                "<TimeStamp><when>2026</when></TimeStamp><styleUrl>#red</styleUrl><ExtendedData>"
                "<SchemaData schemaUrl=\"#Route\"><SimpleData name=\"RoverId\">A</SimpleData>"
                "<SimpleData name=\"Sequence\">10</SimpleData><SimpleData name=\"Speed\">2"
                "</SimpleData></SchemaData><Data name=\"Crew\"><value>Ann</value></Data>"
                "</ExtendedData>" +
                point() + "</Placemark>\n");
  SourcePlacemark added =
      row("Route", "", {{"RoverId", "A"}, {"Sequence", "5"}}, {"LineString", "31,20 31.1,20"});
  added.description = "new";
  put(plan, {added}, all_);
  EXPECT_THAT(plan.document.text(),
              HasSubstr("<Placemark><description>new</description><styleUrl>#red</styleUrl>"
                        "<ExtendedData><SchemaData schemaUrl=\"#Route\"><SimpleData "
                        "name=\"RoverId\">A</SimpleData><SimpleData name=\"Sequence\">5"
                        "</SimpleData></SchemaData></ExtendedData><LineString><tessellate>1"
                        "</tessellate><coordinates>31,20 31.1,20</coordinates></LineString>"
                        "</Placemark>\n<Placemark><name>a</name><Snippet>s</Snippet>"));
}

TEST_F(PutRows, removes_only_kinds_that_the_sheet_has) {
  TestPlan plan(mission() + rover("A") + rover("B") + pause("a", "A", 10) + pause("b", "B", 10));
  const RowChanges changes =
      put(plan, {row("Pause", "a", {{"RoverId", "A"}, {"Sequence", "10"}, {"Duration", "10"}})},
          all_, true);
  EXPECT_THAT(listed_events(plan.edited()), ElementsAre("A/10 Pause 'a'"));
  EXPECT_EQ(plan.edited().rovers.size(), 2u);
  EXPECT_EQ(changes.without_row.size(), 3u) << "the mission and both rovers";
}

TEST_F(PutRows, a_place_in_a_track_is_not_changed) {
  TestPlan plan(
      "<Placemark><name>t</name><ExtendedData><SchemaData schemaUrl=\"#Route\">"
      "<SimpleData name=\"RoverId\">A</SimpleData><SimpleData name=\"Sequence\">10"
      "</SimpleData></SchemaData></ExtendedData><gx:Track "
      "xmlns:gx=\"http://www.google.com/kml/ext/2.2\"><gx:coord>31 20 0</gx:coord>"
      "<gx:coord>31.1 20 0</gx:coord></gx:Track></Placemark>\n" +
      mission() + rover("A"));
  const PlanMark& mark = plan.document.mark(plan.event("A", 10));
  try {
    set_places(plan.document, mark, {"Point", "31,20"});
    ADD_FAILURE() << "it was changed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("plan.kml:4: Route 't': its place stands in no "
                                        "<coordinates> (but a Camera or a gx:Track), and is not "
                                        "changed"));
  }
}

}  // namespace
}  // namespace lsos::test
