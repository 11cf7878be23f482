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

Mission two_rovers() {
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
  const Mission mission = two_rovers();
  for (const double time_s : {0.1, 5.0, 15.0, 22.0, 25.0}) {
    EXPECT_EQ(refusal(mission, state_at(mission, time_s)), "") << time_s;
  }
}

TEST(ForeignState, may_differ_anywhere) {
  const Mission mission = two_rovers();
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
  const Mission mission = two_rovers();
  const std::string state = state_at(mission, 5);
  EXPECT_THAT(refusal(mission, state.substr(0, state.size() / 2)), HasSubstr("ends too early"));
  EXPECT_THAT(refusal(mission, state + "x"), HasSubstr("longer than the program expects"));
}

TEST(ForeignState, is_of_this_mission) {
  const Mission mission = two_rovers();
  Mission empty, other, fewer = two_rovers(), timed = two_rovers();
  empty.rover("A");  // this mission is over where it begins
  other.rover("A").event("Hold", 5);
  fewer.setup_.plan.events.pop_back();
  timed.setup_.plan.events.front().at = test::milliseconds(100'000);
  for (const Mission* foreign : {&empty, &other, &fewer, &timed}) {
    EXPECT_THAT(refusal(mission, state_at(*foreign, 1)), HasSubstr("other events"));
    EXPECT_THAT(refusal(*foreign, state_at(mission, 1)), HasSubstr("other events"));
  }
}

}  // namespace
}  // namespace lsos
