#include "plan/xml_element.h"

#include "base/text.h"

namespace lsos {

using tinyxml2::XMLElement;

std::string_view local_name(const XMLElement& element) {
  const std::string_view name = element.Name();
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

LinedText text_of(const XMLElement& element) {
  LinedText found{{}, element.GetLineNum()};
  bool has_text = false;
  for (const auto* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    const tinyxml2::XMLText* text = node->ToText();
    if (text == nullptr) continue;
    if (!has_text && !trimmed(text->Value()).empty()) {
      has_text = true;
      found.line = text->GetLineNum();
    }
    found.text += text->Value();
  }
  found.text = std::string(trimmed(found.text));
  return found;
}

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? std::string() : std::string(trimmed(value));
}

const XMLElement* child(const XMLElement& parent, std::string_view name) {
  for (const auto* each = parent.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (local_name(*each) == name) return each;
  }
  return nullptr;
}

}  // namespace lsos
