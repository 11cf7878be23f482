// Reads the text of a KML document in any encoding.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lsos {

// Greatest size of an unpacked document: a KMZ of a few kilobytes can unpack to gigabytes.
inline constexpr std::size_t max_kml_bytes = std::size_t{256} << 20;

struct KmlText {
  std::string file;  // for messages: "plan.kml", "plan.kmz/doc.kml"
  std::string utf8;  // without byte order mark
};

// All bytes of `file`. Throws InputError when it cannot be read or is too large.
std::string read_bytes(const std::string& file);

// Converts UTF-16, UTF-32 and declared 8-bit encodings to UTF-8. Throws InputError when the bytes
// are not XML, or not valid in their encoding.
KmlText kml_text(std::string bytes, const std::string& file);

// Throws InputError for markup that the parser would misread (entities of the document's own) or
// need minutes for (thousands of attributes).
void check_markup(const KmlText& text);

// Steps of kml_text(). The first throws InputError when the first bytes are not XML in any
// encoding, such as JSON, CSV or a raster; the second converts the bytes, or throws InputError.
void refuse_foreign_bytes(std::string_view bytes, const std::string& file);
std::string to_utf8(std::string bytes, const std::string& file);

}  // namespace lsos
