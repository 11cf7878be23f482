// A run as one of its checkpoints has it.
#pragma once

#include <string>
#include <vector>

#include "lua/host/mission_files.h"
#include "lua/host/mission_reader.h"
#include "lua/host/saved_mission.h"
#include "mission/simulation.h"
#include "record/log.h"

namespace lsos {

struct SavedRun {
  std::int64_t id = 0;  // of the checkpoint
  SimTime time{};
  double wall_s = 0;  // wall time that the run had taken
  SavedMission mission;
};

// The checkpoints of an unfinished run, from the oldest on. Throws InputError where there are none
// or where the run has finished.
std::vector<CheckpointEntry> resumable_checkpoints(const std::string& folder);
// Throws InputError where it is damaged or of another form.
SavedRun saved_run(const LogReader& log, const std::string& folder, std::int64_t id);
// The last that can be read; `damaged`: what is wrong with later ones. Throws InputError when none
// can be read.
SavedRun last_saved_run(const std::string& folder, const std::vector<CheckpointEntry>& entries,
                        std::vector<std::string>& damaged);

// The last one at or before a moment that can be read; `damaged`: what is wrong with later ones.
// Throws InputError where there is none.
SavedRun saved_run_before(const LogReader& log, const std::string& folder, SimTime moment,
                          std::vector<std::string>& damaged);

// The copy of the plan that was run; scripts and rasters lie beside the plan itself.
PlanSource source_of_run(const std::string& folder, const SavedMission& mission);
// The mission that was run, from the copy of its plan, with the scripts and rasters of the folder
// of the plan. Throws InputError.
MissionFiles files_of_run(const std::string& folder, const SavedMission& mission);

// Throws InputError where the state does not fit.
void restore(Simulation& simulation, const SavedRun& saved, const std::string& folder);

}  // namespace lsos
