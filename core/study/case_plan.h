// The plan of one case: the document of the study's plan with the case's values put in, which any
// command reads as a plan of its own.
#pragma once

#include <string>
#include <vector>

#include "edit/plan_document.h"
#include "plan/plan.h"
#include "study/parameter.h"

namespace lsos {

// The Placemark that an address is of.
const PlanMark& mark_of(const PlanDocument& document, const Address& address);

// The study's plan, for the fields CaseOf and CaseOfSha256 of its cases.
struct CaseOrigin {
  std::string plan;    // as seen from the folder of the case; "": neither field
  std::string sha256;  // of its file
};

// `kml`: the document that `plan` was read from, without errors. Throws InputError where a place
// stands in no <coordinates>.
std::string case_plan(const std::string& kml, const Plan& plan, const Declarations& declarations,
                      const std::vector<Draw>& draws, const CaseOrigin& origin);

// A Variant or SoilVariant with another value of one key: "mass_kg = 3; battery.capacity_j = 1e8".
std::string changed_variant(const std::string& variant, const std::string& key,
                            const std::string& value);

}  // namespace lsos
