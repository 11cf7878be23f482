// Which events an edit is for, and what enable and disable do to them.
#include "edit/event_choice.h"

#include "edit/enable.h"
#include "edit_fixture.h"

namespace lsos::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string two_days() {
  return mission() + rover("A") + rover("B") + pause("eva", "A", 10) + pause("rest", "A", 20) +
         pause("eva", "A", 30, {{"StartTime", "2026-07-02T08:00"}}) +
         event("Route", "drive", "B", 10, {}, line()) +
         pause("eva", "B", 20, {{"Enabled", "false"}, {"StartTime", "2026-07-02"}});
}

std::vector<std::string> chosen(const EventChoice& choice) {
  const TestPlan plan(two_days());
  std::vector<std::string> names;
  for (const PlanEvent* event : chosen_events(plan.plan, choice, plan.days())) {
    names.push_back(event->rover_id + "/" + std::to_string(event->sequence));
  }
  return names;
}

EventChoice ranges(std::vector<std::string> texts) { return {std::move(texts), "", "", ""}; }

TEST(EventChoice, is_by_sequences_labels_types_days_and_rovers) {
  EXPECT_THAT(chosen(ranges({"A/20"})), ElementsAre("A/20"));
  EXPECT_THAT(chosen(ranges({"B/20", "A/10..20"})), ElementsAre("A/10", "A/20", "B/20"));
  EXPECT_THAT(chosen({{}, "", "eva", ""}), ElementsAre("A/10", "A/30", "B/20"));
  EXPECT_THAT(chosen({{}, "", "", "Route"}), ElementsAre("B/10"));
  EXPECT_THAT(chosen({{}, "", "", "", 2, 2}), ElementsAre("A/30", "B/20"));
  EXPECT_THAT(chosen({{}, "A", "eva", "", 1, 2}), ElementsAre("A/10", "A/30"));
}

TEST(EventChoice, says_what_there_is_none_of) {
  const auto fault = [](const EventChoice& choice) {
    try {
      chosen(choice);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(fault(ranges({"A/25"})), HasSubstr("rover 'A' has no event there; its sequences are "
                                                 "10, 20, 30"));
  EXPECT_THAT(fault(ranges({"A"})), HasSubstr("ROVER/SEQUENCE or ROVER/FIRST..LAST is wanted"));
  EXPECT_THAT(fault(ranges({"A/30..20"})), HasSubstr("ROVER/FIRST..LAST is wanted"));
  EXPECT_THAT(fault(ranges({"C/10"})), HasSubstr("'C/10': the plan has no rover 'C'; there are A"));
  EXPECT_THAT(fault({{}, "", "evas", ""}), HasSubstr("no event 'evas'; did you mean 'eva'?"));
  EXPECT_THAT(fault({{}, "", "", "Rout"}), HasSubstr("type 'Rout'; did you mean 'Route'?"));
  EXPECT_THAT(fault({{}, "", "", "", 3, 4}), HasSubstr("it has 5 events on 2 days"));
}

TEST(Enable, sets_what_is_not_so_already) {
  TestPlan plan(two_days());
  const auto all = chosen_events(plan.plan, {{}, "", "eva", ""}, plan.days());
  EXPECT_EQ(set_enabled(plan.document, all, false), 2);
  const Plan disabled = plan.edited();
  for (const PlanEvent& event : disabled.events) EXPECT_EQ(event.is_enabled, event.label != "eva");
  PlanDocument again(plan.document.text(), disabled, plan.known);
  // The bytes must live as long as the document.
  const std::string text = plan.document.text();
  PlanDocument back(text, disabled, plan.known);
  std::vector<const PlanEvent*> events;
  for (const PlanEvent& event : disabled.events) events.push_back(&event);
  EXPECT_EQ(set_enabled(back, events, true), 3);
}

// Viewers leave out fields that a Schema has not.
TEST(Enable, declares_a_new_field_in_its_schema) {
  TestPlan plan(two_days(),
                "<Schema id=\"Pause\" name=\"Pause\">\n  <SimpleField type=\"string\" "
                "name=\"Duration\"/>\n</Schema>\n");
  set_enabled(plan.document, {&plan.event("A", 10), &plan.event("A", 20)}, false);
  EXPECT_THAT(plan.document.text(),
              HasSubstr("<SimpleField type=\"string\" name=\"Duration\"/>\n  <SimpleField "
                        "type=\"string\" name=\"Enabled\"/>\n</Schema>"));
}

// A GIS writes fields in Data, and perhaps twice.
TEST(Enable, finds_fields_where_map_tools_put_them) {
  TestPlan plan(
      mission() + rover("A") +
      "<Placemark><ExtendedData><Data name=\"Type\"><value>Pause</value></Data><Data "
      "name=\"RoverId\"><value>A</value></Data><Data name=\"Sequence\"><value>3</value></Data>"
      "<Data name=\"Duration\"><value>5</value></Data></ExtendedData></Placemark>" +
      "<Placemark><ExtendedData><SchemaData schemaUrl=\"#Pause\"><SimpleData "
      "name=\"RoverId\">A</SimpleData><SimpleData name=\"Sequence\">4</SimpleData><SimpleData "
      "name=\"Duration\">5</SimpleData><SimpleData name=\"Enabled\">1</SimpleData></SchemaData>"
      "<Data name=\"Enabled\"><value>1</value></Data></ExtendedData></Placemark>");
  EXPECT_EQ(set_enabled(plan.document, {&plan.event("A", 3), &plan.event("A", 4)}, false), 2);
  for (const PlanEvent& event : plan.edited().events) EXPECT_FALSE(event.is_enabled);
}

}  // namespace
}  // namespace lsos::test
