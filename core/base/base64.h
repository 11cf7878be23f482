// Bytes encoded as text, for embedding in a page.
#pragma once

#include <string>
#include <string_view>

namespace lsos {

// `bytes`: less than 1.5 GB.
std::string base64(std::string_view bytes);

}  // namespace lsos
