// A page opened in headless Chromium, with a script of the test's own in it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "system/temp_folder.h"

namespace lsos::test {

// "" where no Chromium is installed.
std::string browser();

// Opens a copy of the page and awaits `steps`, the body of an async function in which move(element,
// share), drag(element, from, to), twice(element), click(element), text(selector) and
// rest() stand ready. Answers what it returns; {"error": ...} where it throws. Shares are of the
// width of a plot's axes.
nlohmann::json in_browser(const TempFolder& folder, const std::string& page_file,
                          const std::string& steps);

}  // namespace lsos::test
