// What a log says of the run that it is of.
#pragma once

#include <map>
#include <string>

#include "lua/host/mission_files.h"
#include "mission/simulation.h"

namespace lsos {

// The key of a run that began as another had ended: the digest of that one's log.
inline constexpr const char* from_key = "from_log_sha256";

// The layer `run`: what the run was made of, nothing that differs between two equal runs.
std::map<std::string, std::string> run_values(const MissionFiles& files,
                                              const Simulation& simulation);

// Digests of the scripts that a mission uses, by "rover_SEV_sha256".
std::map<std::string, std::string> script_digests(const MissionFiles& files);

// Tells the plan of a run that began as another had ended where its site is. `run`: those values.
void restore_site(const std::map<std::string, std::string>& run, Plan& plan);

}  // namespace lsos
