// Checks what a plan's events name or use of the equipment of rovers and assets: panels, antennas,
// resources, power sources.
#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "mission/model/rover_model.h"
#include "plan/declaration.h"
#include "plan/plan.h"

namespace lsos {

// Adds an error for each field that names what does not exist (FieldDeclaration::names). When a
// field left out means all and there are none, or when more of a resource is used than is aboard
// (FieldDeclaration::amount_of), it adds a fault as foreseen_failure(). `rovers` are by
// PlanRover::model(), `assets` by type; events of a rover whose model is missing are not checked.
void check_plan_names(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers,
                      const std::map<std::string, AssetModel>& assets, Faults& faults);

}  // namespace lsos
