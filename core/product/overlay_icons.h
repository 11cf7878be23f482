// The icons of an overlay: on a server that KML viewers can reach, or as pictures beside it.
#pragma once

#include <string>
#include <vector>

#include "plan/kml_writer.h"

namespace lsos {

// White shapes, coloured by styles. An arrow that is not rotated points north.
enum class OverlayIcon { arrow, disc, cross, square, diamond };

// Maps an icon to its address in a document.
using IconPlace = std::string (*)(OverlayIcon);
// Address of a similar icon on Google's server.
std::string server_icon(OverlayIcon icon);
// Name in an archive: "icons/arrow.png".
std::string packed_icon(OverlayIcon icon);
// The pictures under those names; the same bytes each time.
std::vector<PackedFile> packed_icons();

}  // namespace lsos
