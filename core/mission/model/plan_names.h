// Checks what a plan's events name or use of the equipment of rovers and assets: panels, antennas,
// resources, power sources.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "base/error.h"
#include "mission/model/rover_model.h"
#include "plan/declaration.h"
#include "plan/plan.h"

namespace lsos {

// What an event takes of its rover's resources and fills up to, beside its fields with
// FieldDeclaration::amount_of, as its script says before the run. Amounts by name.
struct ResourceChange {
  std::map<std::string, double> used;
  std::map<std::string, double> filled;  // at most so much more; infinite: to what was aboard first
};
using ResourceChangeOf = std::function<ResourceChange(const PlanEvent&)>;

// Adds an error for each field that names what does not exist (FieldDeclaration::names). When a
// field left out means all and there are none, or when more of a resource is used than is aboard
// (FieldDeclaration::amount_of, `change_of`), it adds a fault as foreseen_failure(). `rovers` are
// by PlanRover::model(), `assets` by type; events of a rover whose model is missing are not
// checked.
void check_plan_names(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers,
                      const std::map<std::string, AssetModel>& assets,
                      const ResourceChangeOf& change_of, Faults& faults);

}  // namespace lsos
