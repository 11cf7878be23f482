// Paths that are written in a file and mean what lies beside it.
#pragma once

#include <string>

namespace lsos {

// `path` as it is seen from where we run, when it was written in a file of `folder`; an absolute
// one stays. In GDAL's names of files within archives, "/vsizip/ground.zip/ground.tif", the path of
// the archive is what is relative; other virtual files (/vsicurl/, /vsimem/) have none.
std::string path_beside(const std::string& folder, const std::string& path);

}  // namespace lsos
