// Reads elements of an XML document regardless of namespace prefixes.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <string_view>

namespace lsos {

// Name without prefix: "Placemark" for "kml:Placemark". Documents choose their prefixes freely, and
// no two elements that are read here differ in their prefix alone.
std::string_view local_name(const tinyxml2::XMLElement& element);

struct LinedText {
  std::string text;
  int line = 0;
};

// Text and CDATA directly in `element`, trimmed, with the line of its first character.
LinedText text_of(const tinyxml2::XMLElement& element);

// Value of an attribute, trimmed; "" when there is none.
std::string attribute(const tinyxml2::XMLElement& element, const char* name);

// The first child element of that name; nullptr when there is none.
const tinyxml2::XMLElement* child(const tinyxml2::XMLElement& parent, std::string_view name);

}  // namespace lsos
