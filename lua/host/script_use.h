// Determines which of the scripts found are used by a plan.
#pragma once

#include <set>
#include <string>

#include "lua/host/catalog.h"
#include "plan/plan.h"

namespace lsos {

class ScriptUse {
 public:
  // `terrain`: the plan's, as far as it is known.
  ScriptUse(const Catalog& catalog, const Plan& plan, const TerrainSpec& terrain);

  bool has(const Script& script) const;

 private:
  std::set<std::string> events_, rovers_, terrains_, soils_, shared_;
  // The scripts that a broken script names are not known; they may be any.
  bool is_any_event_ = false, is_any_soil_ = false, is_any_shared_ = false;
};

// Adds warnings for scripts that the plan uses and that hide another or are broken. Scripts that
// the plan does not use are ignored.
void add_script_warnings(const Catalog& catalog, const ScriptUse& use, Faults& faults);

}  // namespace lsos
