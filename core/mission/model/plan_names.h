// What a plan's events name or use of what its rovers and assets have: panels, antennas, resources,
// power to give.
#pragma once

#include <map>
#include <string>

#include "base/error.h"
#include "mission/model/rover_model.h"
#include "plan/declaration.h"
#include "plan/plan.h"

namespace lsos {

// An error for each field that names what is not there (FieldDeclaration::names). Where a field
// that is absent means all, or more of a resource is used than is aboard
// (FieldDeclaration::amount_of): a fault as foreseen_failure(). The models are by type; events of a
// rover whose model is missing are left alone.
void check_plan_names(const Plan& plan, const Declarations& declarations,
                      const std::map<std::string, RoverModel>& rovers,
                      const std::map<std::string, AssetModel>& assets, Faults& faults);

}  // namespace lsos
