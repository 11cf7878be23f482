// Converts the encodings that KML files use to UTF-8.
#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <cerrno>
#include <memory>

#include "base/error.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

struct Encoding {
  std::string name;  // as iconv knows it
  std::size_t mark_bytes = 0;
};

// The name in `<?xml version="1.0" encoding="NAME"?>`; "" without one.
std::string declared_encoding(std::string_view bytes) {
  if (!bytes.starts_with("<?xml")) return {};
  const std::string_view declaration = bytes.substr(0, bytes.find("?>"));
  const std::size_t key = declaration.find("encoding");
  if (key == std::string_view::npos) return {};
  const std::size_t open = declaration.find_first_of("\"'", key);
  if (open == std::string_view::npos) return {};
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return {};
  return std::string(declaration.substr(open + 1, close - open - 1));
}

// Detects the encoding as XML 1.0 (5th ed.), appendix F, describes: by the byte order mark, else by
// the bytes of the first '<', else by the declaration in single-byte characters.
Encoding encoding_of(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xef\xbb\xbf"sv)) return {"UTF-8", 3};
  if (bytes.starts_with("\xff\xfe\0\0"sv)) return {"UTF-32LE", 4};
  if (bytes.starts_with("\0\0\xfe\xff"sv)) return {"UTF-32BE", 4};
  if (bytes.starts_with("\xff\xfe"sv)) return {"UTF-16LE", 2};
  if (bytes.starts_with("\xfe\xff"sv)) return {"UTF-16BE", 2};
  if (bytes.starts_with("<\0"sv)) return {"UTF-16LE", 0};
  if (bytes.starts_with("\0<"sv)) return {"UTF-16BE", 0};
  std::string declared = declared_encoding(bytes);
  std::string upper = declared;
  std::ranges::transform(upper, upper.begin(), [](char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  // A declaration that is readable as single bytes cannot be in 16-bit units, whatever it says.
  if (upper.empty() || upper.starts_with("UTF-16") || upper.starts_with("UCS-2")) return {"UTF-8"};
  return {declared, 0};
}

// What iconv_open returns when it fails.
const iconv_t no_converter = reinterpret_cast<iconv_t>(-1);  // NOLINT(performance-no-int-to-ptr)

struct CloseConverter {
  // std::unique_ptr requires this name.
  using pointer = iconv_t;  // NOLINT(readability-identifier-naming)
  void operator()(iconv_t converter) const { iconv_close(converter); }
};

int line_at_end_of(std::string_view utf8) {
  return 1 + static_cast<int>(std::ranges::count(utf8, '\n'));
}

}  // namespace

std::string to_utf8(std::string bytes, const std::string& file) {
  const Encoding encoding = encoding_of(bytes);
  const auto is_name_character = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.' || c == ':';
  };
  // iconv takes options after a slash, which a document must not choose.
  const bool is_name = std::ranges::all_of(encoding.name, is_name_character);
  const iconv_t opened = is_name ? iconv_open("UTF-8", encoding.name.c_str()) : no_converter;
  if (opened == no_converter) {
    throw InputError({file, 1},
                     fmt::format("declares the encoding '{}', which is not known; UTF-8, UTF-16, "
                                 "ISO-8859-1 and windows-1252 are among those that are",
                                 encoding.name));
  }
  const std::unique_ptr<iconv_t, CloseConverter> converter(opened);

  std::string utf8;
  std::string block(std::size_t{1} << 16, '\0');
  char* in = bytes.data() + encoding.mark_bytes;
  std::size_t in_left = bytes.size() - encoding.mark_bytes;
  bool is_valid = true;
  while (in_left > 0 && is_valid) {
    char* out = block.data();
    std::size_t out_left = block.size();
    errno = 0;
    const std::size_t result = iconv(opened, &in, &in_left, &out, &out_left);
    is_valid = result != static_cast<std::size_t>(-1) || errno == E2BIG;
    utf8.append(block.data(), block.size() - out_left);
  }
  if (!is_valid) {
    throw InputError({file, line_at_end_of(utf8)},
                     fmt::format("holds bytes that are not {}; save it as UTF-8, or declare its "
                                 "encoding in the first line, such as "
                                 "<?xml version=\"1.0\" encoding=\"windows-1252\"?>",
                                 encoding.name));
  }
  const std::size_t zero = utf8.find('\0');
  if (zero != std::string::npos) {
    throw InputError({file, line_at_end_of(std::string_view(utf8).substr(0, zero))},
                     "holds a zero byte, so it is no text");
  }
  return utf8;
}

}  // namespace lsos
