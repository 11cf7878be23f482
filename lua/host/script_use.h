// Which of all scripts that are found a plan uses.
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
  std::set<std::string> events_, rovers_, terrains_, soils_;
  // What a broken script names is not known: it may be any.
  bool is_any_event_ = false, is_any_soil_ = false;
};

// Adds a warning for each script that the plan uses in place of another, and for what keeps one
// from being used. Scripts that only lie there are no matter.
void add_script_warnings(const Catalog& catalog, const ScriptUse& use, Faults& faults);

}  // namespace lsos
