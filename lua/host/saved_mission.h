// What a checkpoint holds: the state of a simulation, and what it was made of, so that it goes on
// only with the same.
#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "base/sim_time.h"

namespace lsos {

struct SavedMission {
  std::string build;                          // of the program
  std::string plan_file;                      // absolute; scripts and rasters lie about it
  std::map<std::string, std::string> values;  // run_values()
  SimTime every{};                            // mission time between kept checkpoints; 0: none
  std::string soil;                           // set in place of the terrain's own; "": none was
  std::string from;                           // folder of the run with whose end it began; "": none
  std::string state;                          // Simulation::save()
};

std::string to_bytes(SavedMission mission);
// Throws Archive::Mismatch.
SavedMission saved_mission(const std::string& bytes);

// What differs between a saved mission and what would go on with it, each with what to do.
// `values`: run_values() of that; `folder`: of the saved run. A renderer that differs is a warning
// where that is allowed.
Faults differences(const SavedMission& saved, const std::string& build,
                   const std::map<std::string, std::string>& values, const std::string& folder,
                   bool is_renderer_allowed);

// What draws light and sight in a run that goes on with a renderer from that time on, as layer
// `run` has it: "llvmpipe, from 158 s on softpipe". `saved`: the same so far.
std::string renderers_text(const std::string& saved, const std::string& renderer, SimTime time);

}  // namespace lsos
