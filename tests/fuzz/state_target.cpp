// State of a mission that was saved, of which bytes are changed: it is refused, or the mission goes
// on with it.
#include "base/archive.h"
#include "base/error.h"
#include "fuzz/target.h"
#include "unit/mission/test_mission.h"

namespace {

struct Saved {
  lsos::test::Mission mission;
  std::vector<std::string> states;

  Saved() {
    mission.rover("A");
    mission.event("Twice");
    mission.drive(12);
    mission.rover("B");
    mission.event("Hold", 3).start_after = {{"A", 1}};
    mission.drive(-12);
    lsos::Simulation simulation(mission.setup_);
    simulation.start();
    for (const int seconds : {1, 25, 30}) {
      const lsos::SimTime until{1'000'000LL * seconds};
      while (simulation.now() < until && !simulation.is_finished()) simulation.advance(until);
      states.push_back(simulation.save());
    }
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Saved saved;
  lsos::test::Bytes bytes(data, size);
  const std::uint8_t kind = bytes.byte();
  const std::size_t which = kind % (saved.states.size() + 1);
  try {
    const std::string state = which == saved.states.size()
                                  ? bytes.rest()
                                  : lsos::test::patched(saved.states[which], bytes);
    lsos::Simulation simulation(saved.mission.setup_);
    simulation.restore(state);
    for (int k = 0; k < 12 && !simulation.is_finished(); ++k) simulation.advance();
  } catch (const lsos::Archive::Mismatch&) {
  }
  return 0;
}
