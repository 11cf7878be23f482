// A script that changes a running simulation between two exchanges, by the calls that scenarios
// have.
#pragma once

#include <string>

#include "lua/session/sim_session.h"

namespace lsos {

// Runs the script; its global `sim` is a session of the parts, which come back also where it fails.
// Throws InputError then, with file and line.
void run_change_script(SessionParts& parts, const std::string& file);

}  // namespace lsos
