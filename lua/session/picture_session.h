// A picture of an interactive simulation in its present state.
#pragma once

#include <string>

#include "lua/session/sim_session.h"
#include "picture/picture_frame.h"

namespace lsos {

// Writes a PNG. Throws InputError where there is no such view, rover or folder.
void write_picture(SimSession& session, const PictureRequest& request, const std::string& file);

}  // namespace lsos
