// The text of a KML document, in whatever encoding.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lsos {

// No document may unpack to more than this: a KMZ of a few kilobytes can claim gigabytes.
inline constexpr std::size_t max_kml_bytes = std::size_t{256} << 20;

struct KmlText {
  std::string file;  // for messages: "plan.kml", "plan.kmz/doc.kml"
  std::string utf8;  // without byte order mark
};

// All bytes of `file`. Throws InputError when it cannot be read or is too large.
std::string read_bytes(const std::string& file);

// UTF-16, UTF-32 and declared 8-bit encodings are converted. Throws InputError where the bytes are
// of no XML, or not of their encoding.
KmlText kml_text(std::string bytes, const std::string& file);

// Throws InputError for markup that the parser would misread (entities of the document's own) or
// need minutes for (thousands of attributes).
void check_markup(const KmlText& text);

// Parts of kml_text.
// Throws InputError where the first bytes are of no XML, in whatever encoding: JSON, CSV, a raster.
void refuse_foreign_bytes(std::string_view bytes, const std::string& file);
std::string to_utf8(std::string bytes, const std::string& file);

}  // namespace lsos
