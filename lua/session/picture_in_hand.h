// A picture of a simulation in hand, as it stands.
#pragma once

#include <string>

#include "lua/session/sim_session.h"
#include "picture/picture_frame.h"

namespace lsos {

// Writes a PNG. Throws InputError: no such view or rover, no such folder.
void write_picture(SimSession& session, const PictureWish& wish, const std::string& file);

}  // namespace lsos
