// Saved states that somebody else wrote: each is refused, or the mission goes on with it; nothing
// else happens, whichever byte differs.
#include <gmock/gmock.h>

#include "base/archive.h"
#include "base/error.h"
#include "unit/mission/test_mission.h"

namespace lsos {
namespace {

using test::Mission;
using ::testing::HasSubstr;

Mission mission_of_two() {
  Mission mission;
  mission.rover("A");
  mission.event("Twice");
  mission.drive(12);
  mission.rover("B");
  mission.event("Hold", 3).start_after = {{"A", 1}};
  mission.drive(-12);
  return mission;
}

std::string state_at(const Mission& mission, double time_s) {
  Simulation simulation(mission.setup_);
  simulation.start();
  const SimTime until = from_seconds(time_s);
  while (simulation.now() < until && !simulation.is_finished()) simulation.advance(until);
  return simulation.save();
}

// "" where it is taken up.
std::string refusal(const Mission& mission, const std::string& state) {
  Simulation simulation(mission.setup_);
  try {
    simulation.restore(state);
    for (int k = 0; k < 3 && !simulation.is_finished(); ++k) simulation.advance();
    return "";
  } catch (const Archive::Mismatch& mismatch) {
    return mismatch.what();
  }
}

TEST(ForeignState, is_taken_up_when_nothing_was_changed) {
  const Mission mission = mission_of_two();
  for (const double time_s : {0.1, 5.0, 15.0, 22.0, 25.0}) {
    EXPECT_EQ(refusal(mission, state_at(mission, time_s)), "") << time_s;
  }
}

TEST(ForeignState, may_differ_anywhere) {
  const Mission mission = mission_of_two();
  const std::string state = state_at(mission, 23);
  int refused = 0;
  for (std::size_t at = 0; at < state.size(); at += 509) {
    std::string other = state;
    for (std::size_t k = at; k < std::min(at + 8, other.size()); ++k) other[k] = '\xff';

    refused += refusal(mission, other).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 0);
}

TEST(ForeignState, is_not_cut_or_lengthened) {
  const Mission mission = mission_of_two();
  const std::string state = state_at(mission, 5);
  EXPECT_THAT(refusal(mission, state.substr(0, state.size() / 2)), HasSubstr("ends too early"));
  EXPECT_THAT(refusal(mission, state + "x"), HasSubstr("longer than the program expects"));
}

TEST(ForeignState, is_of_this_mission) {
  const Mission mission = mission_of_two();
  Mission empty, other, fewer = mission_of_two(), timed = mission_of_two();
  empty.rover("A");  // this mission is over where it begins
  other.rover("A").event("Hold", 5);
  fewer.setup_.plan.events.pop_back();
  timed.setup_.plan.events.front().at = test::milliseconds(100'000);
  for (const Mission* foreign : {&empty, &other, &fewer, &timed}) {
    EXPECT_THAT(refusal(mission, state_at(*foreign, 1)), HasSubstr("other events"));
    EXPECT_THAT(refusal(*foreign, state_at(mission, 1)), HasSubstr("other events"));
  }
}

// However fast a state says that a rover is, little is looked for ahead of it.
TEST(ForeignState, foresees_little_of_a_long_line) {
  Mission mission;
  mission.rover("A").drive(50'000);
  Simulation first(mission.setup_);
  first.start();
  while (seconds(first.now()) < 10) first.advance();
  const RoverAgent& agent = *first.fleet().rovers.front().agent;
  std::string state = first.save();
  const auto bytes = [](double number) { return std::string(reinterpret_cast<char*>(&number), 8); };
  const std::size_t at = state.find(bytes(agent.motion().report().v_S_mps.x()));
  ASSERT_NE(at, std::string::npos);
  state.replace(at, 8, bytes(1e9));
  Simulation second(mission.setup_);
  second.restore(state);
  const RoverAgent& fast = *second.fleet().rovers.front().agent;
  ASSERT_EQ(fast.motion().report().v_S_mps.x(), 1e9);
  EXPECT_LT(fast.drive().footprints_ahead(1).size(), 5000u);
}

}  // namespace
}  // namespace lsos
