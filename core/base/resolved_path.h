// Resolution of file paths that are relative to the file in which they are written.
#pragma once

#include <string>

namespace lsos {

// `path`, written in a file of `folder`, relative to the working directory; absolute paths stay. In
// GDAL's names of files within archives, such as "/vsizip/ground.zip/ground.tif", the path of the
// archive is resolved; other virtual files (/vsicurl/, /vsimem/) have no relative path.
std::string resolved_path(const std::string& folder, const std::string& path);

}  // namespace lsos
