// The icons of an overlay: on a server that viewers of KML reach, or as pictures beside it.
#pragma once

#include <string>
#include <vector>

#include "plan/kml_writer.h"

namespace lsos {

// White shapes, to which styles give colours. An arrow points north where it is not turned.
enum class OverlayIcon { arrow, disc, cross, square, diamond };

// Where a document finds an icon.
using IconPlace = std::string (*)(OverlayIcon);
// Where Google keeps one much like it.
std::string server_icon(OverlayIcon icon);
// Its name in an archive: "icons/arrow.png".
std::string packed_icon(OverlayIcon icon);
// The pictures under these names, the same bytes each time.
std::vector<PackedFile> packed_icons();

}  // namespace lsos
