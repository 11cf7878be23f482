#include "lua/check/run_estimate.h"

#include "lua/host/mission_reader.h"
#include "lua/host/run_mission.h"
#include "lua/host/run_values.h"
#include "mission/mission_estimate.h"
#include "product/estimate_text.h"

namespace lsos {

std::string run_estimate(const MissionFiles& files, const std::string& legs, int threads) {
  SimulationSetup setup = simulation_setup(files);
  setup.threads = threads;
  setup.is_estimate = setup.keeps_sight = true;
  if (!legs.empty()) setup.cached_legs = legs;
  Simulation simulation(std::move(setup));
  return estimate_file_text(estimate_mission(simulation));
}

std::string run_estimate_again(const std::string& run_dir, const LogReader& log, int threads) {
  const std::map<std::string, std::string> run = log.run();
  if (run.contains(from_key)) {
    throw InputError({}, "the run began as another ended, and left none");
  }
  const MissionFiles files = mission_of_run(run_dir, run);
  files.faults.throw_if_errors();
  return run_estimate(files, "", threads);
}

}  // namespace lsos
