#include "mission/model/machine.h"

#include <gmock/gmock.h>

namespace lsos {
namespace {

using testing::HasSubstr;

Declarations declarations() {
  Declarations all;
  for (const char* name : {"Route", "Pause"}) {
    EventDeclaration event;
    event.name = name;
    event.start_phase = "begin";
    event.phases = {{"begin", "", ""}, {"end", "", ""}};
    all.events[name] = event;
  }
  return all;
}

Plan plan_of_two() {
  Plan plan;
  plan.mission.planet = find_body("Moon");
  for (const char* id : {"A", "B"}) {
    PlanRover rover;
    rover.id = id;
    rover.type = "SEV";
    plan.rovers.push_back(rover);
    for (const int sequence : {10, 20}) {
      PlanEvent event;
      event.rover_id = id;
      event.sequence = sequence;
      event.type = sequence == 10 ? "Route" : "Pause";
      event.label = std::string("leg \"") + id + "\"";
      plan.events.push_back(event);
    }
  }
  return plan;
}

TEST(Machine, has_one_machine_a_rover_with_its_events_in_sequence) {
  const MissionMachine machine = synthesise(plan_of_two(), declarations());
  ASSERT_EQ(machine.rovers.size(), 2u);
  ASSERT_EQ(machine.rovers[1].events.size(), 2u);
  EXPECT_EQ(machine.rovers[1].events[0].event.sequence, 10);
  EXPECT_EQ(machine.rovers[1].events[1].declaration.name, "Pause");
}

TEST(Machine, is_drawn_from_initialise_through_every_rover_to_terminate) {
  Plan plan = plan_of_two();
  plan.events[2].start_after = {{"A", 20}};
  plan.events[0].on_failure = OnFailure::go_to;
  plan.events[0].go_to_sequence = 20;
  plan.events[1].is_enabled = false;
  const std::string dot = to_dot(synthesise(plan, declarations()));
  EXPECT_THAT(dot, HasSubstr("initialise -> \"A/10\" -> terminate"));
  EXPECT_THAT(dot, HasSubstr("initialise -> \"B/10\" -> \"B/20\" -> terminate"));
  EXPECT_THAT(dot, HasSubstr("\"A/20\" -> \"B/10\" [style=dashed"));
  EXPECT_THAT(dot, HasSubstr("\"A/10\" -> \"A/20\" [style=dotted"));
  EXPECT_THAT(dot, HasSubstr("leg \\\"A\\\""));
}

// Graphviz lays the ranks, which are the columns, side by side.
TEST(Machine, of_many_events_is_drawn_in_rows) {
  Plan plan = plan_of_two();
  plan.events.clear();
  for (int sequence = 1; sequence <= 15; ++sequence) {
    PlanEvent event;
    event.rover_id = "A";
    event.sequence = sequence;
    event.type = "Pause";
    event.label = "stay";
    event.is_enabled = sequence != 6 && sequence != 7;
    plan.events.push_back(event);
  }
  const std::string dot = to_dot(synthesise(plan, declarations()));
  EXPECT_THAT(dot, HasSubstr("{ rank=same; \"A/1\"; \"A/7\"; \"A/13\"; }"));
  EXPECT_THAT(dot, HasSubstr("{ rank=same; \"A/6\"; \"A/12\"; }"));
  EXPECT_THAT(dot, HasSubstr("initialise -> \"A/1\" -> \"A/2\" -> \"A/3\" -> \"A/4\" -> \"A/5\";"));
  EXPECT_THAT(dot, HasSubstr("\"A/5\" -> \"A/8\" [constraint=false];"));
  EXPECT_THAT(dot, HasSubstr("\"A/8\" -> \"A/9\" -> \"A/10\" -> \"A/11\" -> \"A/12\";"));
  EXPECT_THAT(dot, HasSubstr("\"A/15\" -> terminate [constraint=false];"));
  EXPECT_THAT(dot, HasSubstr("initialise -> terminate;")) << "B has no events";
}

}  // namespace
}  // namespace lsos
