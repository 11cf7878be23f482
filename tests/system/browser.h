// Opens a page in headless Chromium with a script of the test in it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "system/temp_folder.h"

namespace lsos::test {

// Name of the Chromium program; "" when none is installed.
std::string browser();

// Opens a copy of the page and awaits `steps`, the body of an async function that can call
// move(element, share), drag(element, from, to), twice(element), click(element), text(selector) and
// rest(). Returns its result, or {"error": ...} when it throws. Shares are fractions of the width
// of a plot's axes.
nlohmann::json in_browser(const TempFolder& folder, const std::string& page_file,
                          const std::string& steps);

}  // namespace lsos::test
