// A script that changes a running simulation between two exchanges, by the calls that scenarios
// have.
#pragma once

#include <memory>
#include <string>

#include "lua/session/sim_session.h"

namespace lsos {

// Runs the script; its global `sim` is the session. Throws InputError with file and line where it
// fails.
std::unique_ptr<SimSession> run_change_script(std::unique_ptr<SimSession> session,
                                              const std::string& file);

}  // namespace lsos
