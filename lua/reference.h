// The text of lua/README.md, made from what is bound to Lua.
#pragma once

#include <string>

namespace lsos {

std::string api_reference();

}  // namespace lsos
