// Bytes as text, for what is written into a page.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

std::string base64(std::string_view bytes);

}  // namespace lsos
