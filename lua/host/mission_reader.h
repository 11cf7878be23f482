// Reading a plan together with the scripts that it names.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lua/host/mission_files.h"
#include "lua/host/script_folders.h"
#include "mission/simulation.h"
#include "plan/kml_reader.h"

namespace lsos {

// Folders of the scripts that a plan can use, or that any plan can use for "".
std::vector<ScriptFolder> script_folders(const std::string& plan_file);
// Rasters beside a plan of the user may be read from now on.
void allow_beside(const std::string& plan_file);
// Catalog of those scripts.
std::shared_ptr<const Catalog> read_catalog(const std::string& plan_file);

// Reads the plan and its scripts, and collects every fault. `seed` replaces the plan's.
MissionFiles read_mission(const std::string& plan_file, std::optional<std::uint64_t> seed = {});

// A plan that is read once and can be made into several missions.
struct PlanSource {
  std::string file;  // base of relative paths
  KmlSource kml;
  std::string soil;     // soil of the ground; "": the terrain's own
  std::string bytes;    // the plan as a KML or KMZ file
  bool is_file = true;  // scripts are found beside `file`; else as for any plan
};
// Allows what lies beside a plan that another file names, where there is one.
void allow_other(const std::string& plan_file);
// Rasters beside it, and beside the plan that it is a case of, may be read from now on.
void allow_around(const PlanSource& source);
// Throws InputError.
PlanSource read_plan_source(const std::string& plan_file);
// Catalog of the scripts that it can use.
std::shared_ptr<const Catalog> read_catalog(const PlanSource& source);
MissionFiles read_mission(const PlanSource& source, std::shared_ptr<const Catalog> catalog,
                          std::optional<std::uint64_t> seed = {});

// What the simulation starts from; the files must have no errors.
SimulationSetup simulation_setup(const MissionFiles& files);

}  // namespace lsos
