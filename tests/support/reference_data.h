// Data against which tests check. They lie beside the repository and are not part of it.
#pragma once

#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace lsos {

inline std::filesystem::path reference_folder() {
  const char* folder = std::getenv("LSOS_REFERENCE_DATA");
  return folder != nullptr ? folder : LSOS_SOURCE_DIR "/../shared/data";
}

inline std::filesystem::path reference_file(const std::filesystem::path& name) {
  return reference_folder() / name;
}

}  // namespace lsos

// Skips the test when there are no reference data at all. The test fails when this file or folder
// is missing among them, or when LSOS_REFERENCE_DATA names no folder: lost data must not go
// unnoticed.
#define LSOS_NEEDS_REFERENCE(name)                                                 \
  do {                                                                             \
    if (!std::filesystem::is_directory(lsos::reference_folder())) {                \
      if (std::getenv("LSOS_REFERENCE_DATA") != nullptr) {                         \
        FAIL() << "LSOS_REFERENCE_DATA names no folder";                           \
      }                                                                            \
      GTEST_SKIP() << "no reference data: " << lsos::reference_folder()            \
                   << " is absent (LSOS_REFERENCE_DATA names another)";            \
    }                                                                              \
    if (!std::filesystem::exists(lsos::reference_file(name))) {                    \
      FAIL() << "the reference data lack " << lsos::reference_file(name).string(); \
    }                                                                              \
  } while (false)
