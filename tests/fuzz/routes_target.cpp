// Routes that an earlier run kept beside its plan, of which bytes are changed; the hash before them
// is that of what stands there, as anybody can compute it.
#include "base/sha256.h"
#include "fuzz/target.h"
#include "mission/routes/planned_legs.h"
#include "unit/mission/test_mission.h"

namespace {

// The planned legs of a mission on a plane, without their hash.
std::string kept_body() {
  lsos::test::Mission mission;
  mission.rover("A");
  mission.drive("Plan", 12);
  lsos::Simulation simulation(mission.setup_);
  simulation.start();
  while (!simulation.is_finished()) simulation.advance();
  constexpr std::size_t hash_bytes = 64;
  const std::string kept = simulation.cached_legs();
  if (kept.size() <= hash_bytes) std::abort();  // there would be nothing to change
  return kept.substr(hash_bytes);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string body = kept_body();
  lsos::test::Bytes bytes(data, size);
  const bool is_whole = bytes.byte() % 2 == 0;
  const std::string kept = is_whole ? bytes.rest() : lsos::test::patched(body, bytes);
  lsos::test::Mission mission;
  mission.rover("A");
  mission.drive("Plan", 12);
  mission.setup_.cached_legs = lsos::sha256_hex(kept) + kept;
  lsos::Simulation simulation(mission.setup_);
  simulation.start();
  for (int k = 0; k < 5 && !simulation.is_finished(); ++k) simulation.advance();
  return 0;
}
