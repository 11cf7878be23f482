// GDAL's drivers that call servers, bounded by file_access.h.
#pragma once

namespace lsos {

bool is_service_driver(const char* name);

// Without the network they only tell what would need it. With it, one opens: GDAL_WMS, whose
// description names the server. Descriptions of the others come from servers, which may send the
// user's own files as theirs ("file:///etc/passwd" is an address to libcurl).
void bound_service_drivers();

}  // namespace lsos
