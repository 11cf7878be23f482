// Catalog of the scripts in events/, rovers/, terrain/, terrain/soils/ and lib/ of several folders.
// Where two scripts have the same name, the one in the earlier folder is used.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "lua/runtime/script.h"
#include "mission/model/rover_model.h"
#include "plan/declaration.h"
#include "terrain/spec/terrain_spec.h"

namespace lsos {

class EventLibrary;
class LuaState;

class Catalog {
 public:
  // Reads and loads every script once; what changes on disk later is not seen. A broken script is
  // left out and costs only a warning, so that a plan that does not use it runs.
  explicit Catalog(const std::vector<ScriptFolder>& folders);
  // The same for plain folders.
  explicit Catalog(const std::vector<std::string>& folders);

  const Declarations& declarations() const { return declarations_; }

  // Warnings: scripts that are broken (with each of their faults) or hidden by another.
  const Faults& faults() const { return faults_; }
  // Errors of a script that exists but is broken; empty for any other name. Where a plan names such
  // an event they say more than "unknown".
  std::vector<Fault> faults_of(ScriptKind kind, const std::string& name) const;

  // The rover that a script defines. Throws InputError with the script's faults if it is broken;
  // or, if there is no such script, with a fault at `requested_at` that suggests the nearest name.
  RoverModel load_rover(const std::string& name, const Place& requested_at = {}) const;
  // The same rover with changes that a plan makes, written as the Lua table that lsos.derive takes.
  // Faults in the changes are placed at `requested_at` and begin with `what`; numbers of another
  // order of magnitude than the rover's own are warnings.
  RoverModel load_variant(const std::string& name, const std::string& changes,
                          const std::string& what, const Place& requested_at, Faults& faults) const;
  // Names of the scripts in rovers/ that the script `name` is derived from.
  std::set<std::string> bases_of(const std::string& name) const;
  // Names of the scripts in lib/ that a script requires, also through others.
  std::set<std::string> required_by(ScriptKind kind, const std::string& name) const;
  AssetModel load_asset(const std::string& name, const Place& requested_at = {}) const;
  TerrainSpec load_terrain(const std::string& name, const Place& requested_at = {}) const;
  Soil load_soil(const std::string& name, const Place& requested_at = {}) const;
  // A soil with changes that a plan makes, written as a Lua table of keys of lsos.soil. Throws
  // InputError with faults at `requested_at` that begin with `what`.
  Soil changed_soil(const Soil& soil, const std::string& changes, const std::string& what,
                    const Place& requested_at) const;

  // All scripts that no other hides, ordered by kind and name, for the hashes of a run.
  const std::vector<Script>& scripts() const { return scripts_; }

 private:
  using Key = std::pair<ScriptKind, std::string>;

  void load_all();
  void load_one(EventLibrary& library, const Script& script, Faults& faults, Faults& event_faults);
  void load_rover_script(LuaState& lua, const Script& script, Faults& faults);
  void add_broken(const Script& script, const Faults& faults);
  template <class T>
  const T& find(const std::map<std::string, T>& things, ScriptKind kind, const std::string& name,
                const Place& requested_at) const;

  std::vector<Script> scripts_;
  Declarations declarations_;
  Faults faults_;
  std::map<Key, std::vector<Fault>> broken_;
  std::map<std::string, RoverModel> rovers_;
  std::map<std::string, AssetModel> assets_;
  std::map<std::string, std::set<std::string>> bases_;  // by name of the derived rover
  std::map<Key, std::set<std::string>> required_;       // scripts of lib/
  std::map<std::string, TerrainSpec> terrains_;
  std::map<std::string, Soil> soils_;
};

}  // namespace lsos
