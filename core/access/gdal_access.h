// GDAL within the bounds of file_access.h.
#pragma once

namespace lsos {

// Registers GDAL's drivers, once; where access is restricted, only those that read files and open
// them as GDAL's file systems do, which are then bounded. Called before anything is opened with
// GDAL.
void register_drivers();

}  // namespace lsos
