#include "lua/study/shared_preparation.h"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>

#include "base/console.h"
#include "lua/host/cached_routes.h"
#include "mission/shared_ground.h"

namespace lsos {

namespace {

bool is_ground_varied(const StudyFiles& files) {
  return std::ranges::any_of(files.parameters, [](const Parameter& parameter) {
    const Address& of = parameter.address;
    return of.of == Address::Of::mission && (of.name == "Seed" || of.name == "Terrain");
  });
}

}  // namespace

void prepare_for_cases(const StudyFiles& files, int threads, bool is_quiet) {
  if (is_ground_varied(files)) return;
  constexpr double longest_s = 30;  // the rest is left to the cases
  SimulationSetup setup = simulation_setup(files.base);
  setup.threads = threads;
  setup.is_preparation = true;
  setup.cache_legs = [file = files.base.plan.home](const std::string& bytes) {
    cache_legs(file, bytes);
  };
  bool is_told = is_quiet;
  setup.on_planning = [&is_told](const std::string& what) {
    if (what.empty() || std::exchange(is_told, true)) return;
    print_message("planning the ways that cases share\n");
  };
  try {
    share_ground(Simulation(std::move(setup)), longest_s);
  } catch (const std::exception&) {
    // Each case tells what is wrong with its own plan, or that the machine fails.
  }
}

}  // namespace lsos
