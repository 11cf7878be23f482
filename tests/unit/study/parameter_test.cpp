// What varies in a study, and the plans of its cases.
#include "study/parameter.h"

#include <cmath>

#include "planet/body.h"
#include "unit/study/study_fixture.h"

namespace lsos::test {
namespace {

using ::testing::HasSubstr;

std::string drawn_text(const Variation& variation, double share) {
  const StudyPlan plan;
  const auto parameters = plan.parameters({variation});
  if (parameters.empty()) return "";
  return draw(parameters.front(), {{parameters.front().name(), share}}).text;
}

TEST(Parameter, is_written_as_a_plan_has_it) {
  EXPECT_EQ(drawn_text(vary("out.Speed", Form::uniform, {"2", "4 m/s"}), 0.5), "3 m/s");
  EXPECT_EQ(drawn_text(vary("A/20.Duration", Form::uniform, {"1 min", "3 min"}), 0.5), "120 s");
  EXPECT_EQ(drawn_text(vary("MissionInfo.StartTime", Form::uniform,
                            {"2026-07-01T00:00:00Z", "2026-07-01T02:00:00Z"}),
                       0.5),
            "2026-07-01T01:00:00.000Z");
  EXPECT_EQ(drawn_text(vary("Rover A.InitialCharge", Form::list, {"50 %", "0.7"}), 0.2), "50 %");
  EXPECT_EQ(drawn_text(vary("MissionInfo.OnFailure", Form::list, {"skip", "abort"}), 0.9), "abort");
}

TEST(Parameter, of_whole_numbers_takes_each_as_often) {
  const Variation seed = vary("MissionInfo.Seed", Form::uniform, {"1", "4"});
  EXPECT_EQ(drawn_text(seed, 0), "1");
  EXPECT_EQ(drawn_text(seed, 0.26), "2");
  EXPECT_EQ(drawn_text(seed, 0.9999), "4");
}

TEST(Parameter, goes_in_steps_through_a_range) {
  const StudyPlan plan;
  const auto parameters = plan.parameters({vary("out.Speed", Form::range, {"1", "2", "0.25"})});
  EXPECT_THAT(parameters.front().choices,
              ::testing::ElementsAre("1 m/s", "1.25 m/s", "1.5 m/s", "1.75 m/s", "2 m/s"));
}

TEST(Parameter, multiplies_what_is_there) {
  EXPECT_EQ(drawn_text(vary("out.Speed", Form::uniform, {"0.5", "1.5"}, true), 0.75), "2.5 m/s");
  EXPECT_EQ(drawn_text(vary("Rover A.battery.capacity_j", Form::list, {"0.9"}, true), 0),
            "90000000");
}

TEST(Parameter, has_its_value_in_si) {
  const StudyPlan plan;
  const auto parameters =
      plan.parameters({vary("out.Speed", Form::list, {"3.6 km/h"}),
                       vary("Rover A.battery.capacity_j", Form::list, {"1 kWh"})});
  const auto all = draws(parameters, {{"A/10.Speed", 0}, {"Rover A.battery.capacity_j", 0}});
  EXPECT_DOUBLE_EQ(std::get<double>(all[0].values.front().second), 1);
  EXPECT_DOUBLE_EQ(std::get<double>(all[1].values.front().second), 3.6e6);
}

TEST(Parameter, refuses_what_its_field_refuses) {
  const StudyPlan plan;
  EXPECT_THAT(plan.faults_of(vary("out.Speed", Form::uniform, {"0.01", "2"})),
              HasSubstr("s.lua:7: vary 'out.Speed': Speed = 0.01: must be at least 0.05 m/s"));
  EXPECT_THAT(plan.faults_of(vary("out.Speed", Form::list, {"2 kg"})), HasSubstr("s.lua:7: "));
  EXPECT_THAT(plan.faults_of(vary("out.Speed", Form::uniform, {"4", "2"})),
              HasSubstr("the first bound must be less than the second"));
  EXPECT_THAT(plan.faults_of(vary("out.Speed", Form::uniform, {"0.01", "2"}, true)),
              HasSubstr("must be at least 0.05 m/s"))
      << "of the plan's 2 m/s";
  EXPECT_THAT(plan.faults_of(vary("MissionInfo.OnFailure", Form::uniform, {"1", "2"})),
              HasSubstr("OnFailure is no number: it varies by list"));
  EXPECT_THAT(plan.faults_of(vary("MissionInfo.OnFailure", Form::list, {"1"}, true)),
              HasSubstr("factor: there is no number in the plan or script"));
  EXPECT_THAT(plan.faults_of(vary("out.Speed", Form::within, {"5 m"})),
              HasSubstr("'within' is of places"));
  EXPECT_THAT(plan.faults_of(vary("out.Place", Form::list, {"5 m"})),
              HasSubstr("a place varies within = a radius"));
  EXPECT_THAT(plan.faults_of(vary("out.Speed", Form::normal, {"2", "0.1", "4", "5"})),
              HasSubstr("more than 8 deviations from the mean"));
}

TEST(Parameter, varies_once) {
  const StudyPlan plan;
  Study study;
  study.varied = {vary("out.Speed", Form::list, {"1"}), vary("A/10.Speed", Form::list, {"2"})};
  Faults faults;
  parameters_of(study, plan.context(), faults);
  ASSERT_EQ(faults.sorted().size(), 1u);
  EXPECT_THAT(faults.sorted().front().what, HasSubstr("varies already, see line 7"));
}

// A disc's places: as many in the inner disc of half the area as in the ring around it.
TEST(Parameter, moves_a_place_within_a_radius) {
  const StudyPlan plan;
  const auto parameters = plan.parameters({vary("out.Place", Form::within, {"10 m"})});
  const Sampler sampler(Sampling::random, 1, 4000, parameters.front().dimensions());
  int inner = 0, east = 0;
  for (std::int64_t number = 1; number <= 4000; ++number) {
    const Draw place = draw(parameters.front(), sampler.shares(number));
    ASSERT_LE(place.offset_m.norm(), 10);
    inner += place.offset_m.norm() < 10 / std::sqrt(2) ? 1 : 0;
    east += place.offset_m.x() > 0 ? 1 : 0;
  }
  EXPECT_NEAR(inner, 2000, 120) << "four deviations of a binomial distribution";
  EXPECT_NEAR(east, 2000, 120);
}

TEST(CasePlan, is_the_plan_with_the_values_of_the_case) {
  const StudyPlan plan;
  const auto parameters = plan.parameters(
      {vary("out.Speed", Form::list, {"3 m/s"}),
       vary("Rover A.battery.capacity_j", Form::list, {"1 kWh"}),
       vary("Rover A.mass_kg", Form::list, {"5"}), vary("Soil.cohesion_pa", Form::list, {"300"}),
       vary("MissionInfo.StartTime", Form::list, {"2026-07-01T01:00"})});
  std::map<std::string, double> shares;
  for (const Parameter& parameter : parameters) shares[parameter.name()] = 0;
  const std::string text =
      case_plan(plan.text, plan.plan, plan.known, draws(parameters, shares), {});
  const Plan made = plan.read(text);
  EXPECT_EQ(std::get<double>(made.events[0].params.at("speed_mps")), 3);
  EXPECT_EQ(made.rovers[0].variant, "battery.capacity_j = 1 kWh; mass_kg = 5");
  EXPECT_EQ(made.rovers[0].initial_charge, 0.8);
  EXPECT_EQ(made.mission.soil_variant, "cohesion_pa = 300");
  EXPECT_EQ(format_utc(made.mission.start_time), "2026-07-01T01:00:00.000Z");
  EXPECT_EQ(made.mission.seed, 7u);
}

// Generated ground is laid out about the start of the first rover: it must not go with it.
TEST(CasePlan, moves_the_first_rover_over_the_same_ground) {
  const StudyPlan plan;
  const auto site_with = [&](const std::string& moved) {
    const auto parameters = plan.parameters({vary(moved, Form::within, {"100 m"})});
    const std::string name = moved == "Rover A.Place" ? "Rover A.Place" : "Rover B.2.Place";
    const Draw place = draw(parameters.front(), {{name + ".angle", 0.25}, {name + ".radius", 1}});
    return plan.read(case_plan(plan.text, plan.plan, plan.known, {place}, {}));
  };
  const Geodetic& start = plan.plan.rovers[0].start;
  const Plan first = site_with("Rover A.Place"), second = site_with("Rover B.2.Place");
  EXPECT_NEAR(surface_distance_m(*first.mission.planet, first.rovers[0].start, start), 100, 0.01);
  EXPECT_EQ(site_of(first).lon_rad, start.lon_rad);
  EXPECT_EQ(site_of(first).lat_rad, start.lat_rad);
  EXPECT_FALSE(second.mission.site);
}

TEST(CasePlan, has_the_site_that_varies_though_the_first_rover_does_too) {
  const StudyPlan plan;
  const auto parameters =
      plan.parameters({vary("Rover A.Place", Form::within, {"100 m"}),
                       vary("MissionInfo.SiteOrigin", Form::list, {"31.2,20.1"})});
  const std::map<std::string, double> shares{
      {"Rover A.Place.angle", 0.25}, {"Rover A.Place.radius", 1}, {"MissionInfo.SiteOrigin", 0}};
  const Plan made =
      plan.read(case_plan(plan.text, plan.plan, plan.known, draws(parameters, shares), {}));
  EXPECT_EQ(site_of(made).lon_rad, geodetic_from_degrees(31.2, 20.1).lon_rad);
}

TEST(CasePlan, moves_all_of_a_line) {
  const StudyPlan plan;
  auto parameters = plan.parameters({vary("out.Place", Form::within, {"100 m"})});
  const Draw place =
      draw(parameters.front(), {{"A/10.Place.angle", 0.25}, {"A/10.Place.radius", 1}});
  const Plan made = plan.read(case_plan(plan.text, plan.plan, plan.known, {place}, {}));
  const Body& moon = *plan.plan.mission.planet;
  for (std::size_t i = 0; i < 2; ++i) {
    const Geodetic &before = plan.plan.events[0].geometry.points[i],
                   &after = made.events[0].geometry.points[i];
    EXPECT_NEAR(surface_distance_m(moon, before, after), 100, 0.01);
    EXPECT_GT(after.lon_rad, before.lon_rad) << "eastwards";
  }
}

TEST(ChangedVariant, replaces_a_key_once) {
  EXPECT_EQ(changed_variant("", "a.b", "3"), "a.b = 3");
  EXPECT_EQ(changed_variant("a.b = 2; c = 1", "a.b", "3"), "c = 1; a.b = 3");
  EXPECT_EQ(changed_variant("a.b2 = 2;", "a.b", "3"), "a.b2 = 2; a.b = 3");
}

}  // namespace
}  // namespace lsos::test
