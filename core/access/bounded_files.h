// GDAL's file systems, bounded by file_access.h.
#pragma once

namespace lsos {

// Puts a check before GDAL's own file systems: a local file is opened where it is allowed, and
// files of the network where connections are. Sources of a VRT and files within archives pass
// through these too.
void bound_file_systems();

}  // namespace lsos
