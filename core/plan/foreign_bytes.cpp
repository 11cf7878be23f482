// Recognises files that are not XML and says what they are instead.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

using namespace std::string_view_literals;

struct Magic {
  std::string_view bytes;
  std::string_view what;
};
constexpr std::array magics{
    Magic{"II*\0"sv, "a TIFF raster; the plan names it in its Terrain"},
    Magic{"MM\0*"sv, "a TIFF raster; the plan names it in its Terrain"},
    Magic{"II+\0"sv, "a TIFF raster; the plan names it in its Terrain"},
    Magic{"\x1f\x8b"sv, "packed with gzip; unpack it first"},
    Magic{"BZh"sv, "packed with bzip2; unpack it first"},
    Magic{"\xfd"
          "7zXZ"sv,
          "packed with xz; unpack it first"},
    Magic{"7z\xbc\xaf"sv, "packed with 7-Zip; unpack it first"},
    Magic{"SQLite format 3\0"sv, "an SQLite database, such as a GeoPackage, inside an archive"},
    Magic{"\x89PNG"sv, "a PNG picture"},
    Magic{"\xff\xd8\xff"sv, "a JPEG picture"},
    Magic{"%PDF"sv, "a PDF document"},
    Magic{"\x89HDF"sv, "an HDF or NetCDF file"},
    Magic{"CDF"sv, "a NetCDF file"},
    Magic{"\0\0'\x0a"sv, "a shapefile; export it as KML"},
    Magic{"\xd0\xcf\x11\xe0"sv, "an Office document; export it as KML"},
};

constexpr std::string_view blanks = " \t\r\n";

// What a text is that does not begin with a tag.
std::string kind_of_text(std::string_view text) {
  if (text.front() == '{' || text.front() == '[') return "JSON; export it as KML";
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  const bool is_printable = std::ranges::all_of(
      line, [](char c) { return c == '\t' || static_cast<unsigned char>(c) >= ' '; });
  if (!is_printable) return "neither text nor a known format";
  const bool has_columns = line.find_first_of(",;\t") != std::string_view::npos;
  return has_columns ? "a table of text, such as CSV; export it as KML" : "text without a tag";
}

}  // namespace

void refuse_foreign_bytes(std::string_view bytes, const std::string& file) {
  const auto refuse = [&](std::string_view what) {
    throw InputError({file, 1},
                     fmt::format("is no XML: it is {}; a KML or KMZ file is wanted", what));
  };
  for (const Magic& magic : magics) {
    if (bytes.starts_with(magic.bytes)) refuse(magic.what);
  }
  if (bytes.starts_with("\xef\xbb\xbf"sv)) bytes.remove_prefix(3);
  const bool is_wide =
      bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv) || bytes.starts_with('\0');
  const std::size_t first = bytes.find_first_not_of(blanks);
  if (is_wide || first == std::string_view::npos || bytes[first] == '<') return;
  refuse(kind_of_text(bytes.substr(first)));
}

}  // namespace lsos
