// PROJ's files, bounded by file_access.h.
#pragma once

namespace lsos {

// Allows PROJ's own folders. A program that calls this has a check before the files that PROJ
// opens, such as grids that a coordinate reference system names by their path.
void bound_projections();

}  // namespace lsos
