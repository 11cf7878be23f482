// Writes core/vehicle/VALIDATION.md and its figures, which compare the wheel-soil model with
// measured single wheels.

#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <fstream>

#include "validation/report.h"

int main() {
  using namespace lsos::validation;
  try {
    for (const auto& [path, text] : report(fit_all(data_folder()))) {
      const std::filesystem::path file = std::filesystem::path(LSOS_SOURCE_DIR) / path;
      std::filesystem::create_directories(file.parent_path());
      std::ofstream(file, std::ios::binary) << text;
      fmt::print("{}\n", path);
    }
  } catch (const std::exception& e) {
    fmt::print(stderr,
               "write_validation: {}\nThe measurements are looked for in LSOS_REFERENCE_DATA/"
               "terramech, by default in ../shared/data/terramech.\n",
               e.what());
    return 1;
  }
  return 0;
}
