// Generated ground is laid out about the site of its plan, which an edit may move: another rover is
// the first then, or the first starts elsewhere.
#pragma once

#include <string>

#include "edit/plan_document.h"
#include "lua/host/mission_files.h"

namespace lsos {

// Writes SiteOrigin where the changed document would have generated ground elsewhere than `files`,
// the plan that it was read from. Returns "SiteOrigin = 31,20 keeps the ground where it was"; that
// it goes with the first rover, where the change takes a SiteOrigin away; or "" where nothing
// moves.
std::string keep_ground(PlanDocument& document, const MissionFiles& files);

// Where the generated ground of a plan that another takes up comes to lie elsewhere; "" where it
// stays.
std::string moved_ground(const MissionFiles& taken_up, const Plan& into);

}  // namespace lsos
