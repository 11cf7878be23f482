// Which files may be opened for a plan, whose author need not be its user.
#pragma once

#include <string>

namespace lsos {

// Bounds what the program opens through GDAL to what is allowed by the functions below, and to
// the network only where `has_network`. The program calls it once, first of all; where nobody
// does, as in tests of the library, everything may be opened.
void restrict_access(bool has_network);

bool is_access_restricted();
bool has_network_access();

// All that lies in `folder` or below it. A link counts for what it leads to, on either side.
void allow_folder(const std::string& folder);
// `file`, which need not exist yet, and those beside it that share its stem, such as the .prj and
// .aux.xml of a raster.
void allow_file(const std::string& file);

// The folder of a raster that the user names, which may lie in an archive:
// "/vsizip/MAPS/all.zip/dem.tif".
void allow_raster(const std::string& name);

bool is_allowed(const std::string& path);
// The file on disk that such a name leads to: the archive.
std::string file_on_disk(const std::string& name);

// What stands in a message about a file that may not be opened: "lies outside ...: --allow-files
// FOLDER allows it".
std::string refused_file(const std::string& path);
// The same of a name that needs a connection.
std::string refused_network(const std::string& name);

}  // namespace lsos
