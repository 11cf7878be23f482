// Refuses XML that is allowed but that the parser cannot read, before parsing.
#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

// Greatest number of attributes of a tag. The parser compares each attribute with all before it:
// 200,000 of them, in a file of two megabytes, take minutes. KML's richest tags have a dozen.
constexpr int most_attributes = 1000;

int line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::ranges::count(text.substr(0, at), '\n'));
}

// The position just after `ending`, or the end of the text.
std::size_t end_after(std::string_view text, std::size_t from, std::string_view ending) {
  const std::size_t found = text.find(ending, from);
  return found == std::string_view::npos ? text.size() : found + ending.size();
}

struct Tag {
  std::size_t end = 0;  // position after its '>', or the end of the text
  int attributes = 0;
};

Tag tag_at(std::string_view text, std::size_t at) {
  Tag tag;
  char quote = 0;
  for (tag.end = at + 1; tag.end < text.size(); ++tag.end) {
    const char c = text[tag.end];
    if (c == '<') break;  // not allowed in a tag: a quote before it is not closed
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '=') {
      ++tag.attributes;
    } else if (c == '>') {
      ++tag.end;
      break;
    }
  }
  return tag;
}

}  // namespace

void check_markup(const KmlText& text) {
  const std::string_view utf8 = text.utf8;
  std::size_t at = 0;
  while ((at = utf8.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = utf8.substr(at);
    if (rest.starts_with("<!--")) {
      at = end_after(utf8, at + 4, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = end_after(utf8, at, "]]>");
    } else if (rest.starts_with("<!DOCTYPE")) {
      const std::size_t stop = rest.find_first_of("[>");
      if (stop != std::string_view::npos && rest[stop] == '[') {
        throw InputError({text.file, line_of(utf8, at)},
                         "declares entities or elements of its own in <!DOCTYPE ... [ ... ]>; they "
                         "are not read: remove it, and write out what its entities stand for");
      }
      at = end_after(utf8, at, ">");
    } else {
      const Tag tag = tag_at(utf8, at);
      if (tag.attributes > most_attributes) {
        throw InputError({text.file, line_of(utf8, at)},
                         fmt::format("has a tag with {} attributes; {} at most are allowed",
                                     tag.attributes, most_attributes));
      }
      at = tag.end;
    }
  }
}

}  // namespace lsos
