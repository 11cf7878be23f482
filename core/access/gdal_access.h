// GDAL within the bounds of file_access.h.
#pragma once

#include <string>

namespace lsos {

// Registers GDAL's drivers, once; where access is restricted, only those that read files and open
// them as GDAL's file systems do, which are then bounded. Called before anything is opened with
// GDAL.
void register_drivers();

// The last refusal on this thread since forget_refusal, "" when there is none. GDAL itself speaks
// only of a file that cannot be opened.
const std::string& last_refusal();
void forget_refusal();

}  // namespace lsos
