// Addresses of what varies in a study.
#include "study/address.h"

#include "unit/study/study_fixture.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

std::string text_of(const std::string& address) {
  const StudyPlan plan;
  const Parsed<Address> found = parse_address(address, plan.plan, plan.known);
  return found ? found.value->text() : "refused: " + found.why;
}

TEST(Address, has_one_form) {
  EXPECT_EQ(text_of("A/10.Speed"), "A/10.Speed");
  EXPECT_EQ(text_of("out.Speed"), "A/10.Speed") << "an event by its label";
  EXPECT_EQ(text_of("A/10.Place"), "A/10.Place");
  EXPECT_EQ(text_of("MissionInfo.StartTime"), "MissionInfo.StartTime");
  EXPECT_EQ(text_of("Rover A.InitialCharge"), "Rover A.InitialCharge");
  EXPECT_EQ(text_of("Rover B.2.battery.capacity_j"), "Rover B.2.battery.capacity_j");
  EXPECT_EQ(text_of("B.2/10.Duration"), "B.2/10.Duration");
  EXPECT_EQ(text_of("Soil.cohesion_pa"), "Soil.cohesion_pa");
}

TEST(Address, tells_a_key_of_a_script_from_a_field) {
  const StudyPlan plan;
  const auto what = [&](const std::string& text) {
    return parse_address(text, plan.plan, plan.known).value->what;
  };
  EXPECT_EQ(what("Rover A.InitialCharge"), Address::What::field);
  EXPECT_EQ(what("Rover A.mass_kg"), Address::What::script_key);
  EXPECT_EQ(what("Rover A.Place"), Address::What::place);
}

TEST(Address, suggests_what_may_be_meant) {
  EXPECT_THAT(text_of("A/10.Sped"), HasSubstr("Route has no field 'Sped'; did you mean 'Speed'?"));
  EXPECT_THAT(text_of("ou.Speed"), HasSubstr("the plan has no event 'ou'; did you mean 'out'?"));
  EXPECT_THAT(text_of("Rover a.InitialCharge"),
              HasSubstr("the plan has no rover 'a'; did you mean 'A'?"));
  EXPECT_THAT(text_of("rest.Duration"),
              HasSubstr("2 events are called 'rest'; ROVER/SEQUENCE says which"));
  EXPECT_THAT(text_of("speed"), HasSubstr("says no field; addresses are such as"));
  EXPECT_THAT(text_of("A/20.Place"), HasSubstr("Pause has no field 'Place'"))
      << "it is drawn nowhere";
}

TEST(Address, leaves_what_a_thing_is) {
  EXPECT_THAT(text_of("A/10.RoverId"), HasSubstr("stays as it is drawn"));
  EXPECT_THAT(text_of("MissionInfo.Planet"), HasSubstr("stays as it is drawn"));
}

}  // namespace
}  // namespace lsos::test
