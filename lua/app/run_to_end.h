// Simulates a mission to its end and leaves the results in its folder. What `run`, `resume` and
// `branch` have in common.
#pragma once

#include <chrono>

#include "lua/app/checkpoints.h"
#include "lua/app/planning_watch.h"
#include "lua/app/run_options.h"
#include "lua/host/mission_files.h"
#include "product/run_folder.h"
#include "product/run_record.h"

namespace lsos {

// A mission that is being run, from its start or from a checkpoint.
struct MissionUnderWay {
  MissionFiles& files;
  Simulation& simulation;
  RunFolder& folder;
  RunRecord& record;
  Checkpoints& checkpoints;
};

// Simulates a mission that was read at `options.plan`, from its start. `begin`: when the program
// began with it. Returns the program's exit code. Throws InputError.
int run_files(MissionFiles files, const RunOptions& options,
              std::chrono::steady_clock::time_point begin);

// The setup of a simulation that is to be run to its end; `watch` must outlive it.
SimulationSetup run_setup(const MissionFiles& files, const OutcomeOptions& options,
                          PlanningWatch& watch);

// Returns the program's exit code.
int run_to_end(MissionUnderWay mission, const OutcomeOptions& options);

}  // namespace lsos
