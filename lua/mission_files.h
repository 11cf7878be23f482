// A plan together with the scripts that it names, read and checked.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "lua/catalog.h"
#include "mission/simulation.h"
#include "plan/kml_reader.h"
#include "plan/plan.h"

namespace lsos {

struct MissionFiles {
  std::shared_ptr<const Catalog> catalog;  // shared: each rebuilt script host reads it
  Plan plan;
  std::map<std::string, RoverModel> rover_models;  // by PlanRover::model()
  std::map<std::string, AssetModel> asset_models;  // by AssetType
  TerrainSpec terrain;
  bool is_soil_assumed = false;  // nothing says what the ground is made of
  std::vector<std::string> assumptions;
  Faults faults;           // warnings too
  std::string plan_bytes;  // of the plan's file when it was read; it may change while it is run
};

// Of the scripts that a plan can use, or that any plan can for "".
std::vector<ScriptFolder> script_folders(const std::string& plan_file);
// Those scripts.
std::shared_ptr<const Catalog> read_catalog(const std::string& plan_file);

// Reads all and collects every fault. `seed` replaces the plan's.
MissionFiles read_mission(const std::string& plan_file, std::optional<std::uint64_t> seed = {});

// A plan that was read once, to be made into a mission more than once.
struct PlanSource {
  std::string file;  // what relative paths are relative to
  KmlSource kml;
  std::string soil;     // that the ground is made of; "": the terrain's own
  std::string bytes;    // the same as a KML or KMZ file
  bool is_file = true;  // its scripts are found as those of `file`; else as those of any plan
};
// Throws InputError.
PlanSource read_plan_source(const std::string& plan_file);
MissionFiles read_mission(const PlanSource& source, std::shared_ptr<const Catalog> catalog,
                          std::optional<std::uint64_t> seed = {});

// What the scripts say of the fields of a plan's events, and faults in their conditions. `files`:
// of the plan, with its rovers.
void check_events(const Plan& plan, const MissionFiles& files, Faults& faults);

// What the simulation starts from; the files must have no errors.
SimulationSetup simulation_setup(const MissionFiles& files);

// Legs planned in earlier runs of this very program lie beside the plan: NAME.kml.routes.
std::string read_kept_legs(const std::string& plan_file);
// A warning where something else has that name: then nothing is kept.
std::vector<Fault> kept_legs_advice(const std::string& plan_file);
// Where the plan's folder is not ours to write to, nothing is kept, and the answer is a warning of
// that: the next run plans again.
std::vector<Fault> keep_legs(const std::string& plan_file, const std::string& bytes);

// The layer `run`: what the run was made of, nothing that differs between two equal runs.
std::map<std::string, std::string> run_values(const MissionFiles& files,
                                              const Simulation& simulation);

}  // namespace lsos
