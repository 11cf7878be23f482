#include "plan/kml_reader.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "base/error.h"
#include "plan/kml_text.h"

namespace lsos {

namespace {

using tinyxml2::XMLElement;

// "Placemark" of "kml:Placemark". Documents choose their prefixes freely, and no two elements that
// are looked for differ in their prefix alone.
std::string_view local_name(const XMLElement& element) {
  const std::string_view name = element.Name();
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

struct LinedText {
  std::string text;
  int line = 0;
};

// Text and CDATA directly in `element`, trimmed, with the line of its first character.
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

bool is_geometry(std::string_view name) {
  constexpr std::array<std::string_view, 8> names{"Point",   "LineString",    "LinearRing",
                                                  "Polygon", "MultiGeometry", "Model",
                                                  "Track",   "MultiTrack"};
  return std::ranges::find(names, name) != names.end();
}

// The one geometry in a MultiGeometry, which map tools write round any that could have several;
// nullptr when there are more, or none.
const XMLElement* only_member(const XMLElement& multi) {
  const XMLElement* only = nullptr;
  for (const auto* each = multi.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (!is_geometry(local_name(*each))) continue;
    if (only != nullptr) return nullptr;
    only = each;
  }
  return only;
}

// The holes of a Polygon. Some tools write all rings into one innerBoundaryIs.
std::vector<SourceGeometry::Ring> holes_of(const XMLElement& polygon) {
  std::vector<SourceGeometry::Ring> holes;
  for (const auto* each = polygon.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (local_name(*each) != "innerBoundaryIs") continue;
    for (const auto* ring = each->FirstChildElement(); ring; ring = ring->NextSiblingElement()) {
      if (local_name(*ring) != "LinearRing") continue;
      const XMLElement* coordinates = child(*ring, "coordinates");
      LinedText text =
          coordinates == nullptr ? LinedText{"", ring->GetLineNum()} : text_of(*coordinates);
      holes.push_back({std::move(text.text), text.line});
    }
  }
  return holes;
}

// Depth is bounded by tinyxml2's limit on nested elements.
SourceGeometry geometry(const XMLElement& element) {
  const std::string_view name = local_name(element);
  if (const XMLElement* only = name == "MultiGeometry" ? only_member(element) : nullptr) {
    return geometry(*only);
  }
  SourceGeometry found;
  found.line = element.GetLineNum();
  found.kind = name.ends_with("Track") ? fmt::format("gx:{}", name) : std::string(name);
  const XMLElement* ring = nullptr;
  if (name == "Polygon") {
    const XMLElement* outline = child(element, "outerBoundaryIs");
    if (outline != nullptr) ring = child(*outline, "LinearRing");
    found.holes = holes_of(element);
  }
  if (name != "Point" && name != "LineString" && ring == nullptr) return found;
  if (const XMLElement* coordinates = child(ring == nullptr ? element : *ring, "coordinates")) {
    LinedText text = text_of(*coordinates);
    found.coordinates = std::move(text.text);
    found.line = text.line;
  }
  return found;
}

SourceData schema_data(const XMLElement& element) {
  SourceData data;
  data.line = element.GetLineNum();
  data.schema_url = attribute(element, "schemaUrl");
  for (const auto* each = element.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (local_name(*each) != "SimpleData") continue;
    LinedText text = text_of(*each);
    data.fields.push_back({attribute(*each, "name"), std::move(text.text), text.line});
  }
  return data;
}

SourcePlacemark placemark(const XMLElement& element) {
  SourcePlacemark found;
  found.line = element.GetLineNum();
  for (const auto* each = element.FirstChildElement(); each; each = each->NextSiblingElement()) {
    const std::string_view name = local_name(*each);
    if (name == "name") {
      found.name = text_of(*each).text;
    } else if (name == "ExtendedData") {
      for (const auto* data = each->FirstChildElement(); data; data = data->NextSiblingElement()) {
        if (local_name(*data) == "SchemaData") found.data.push_back(schema_data(*data));
        if (local_name(*data) == "Data") found.plain_data.push_back(attribute(*data, "name"));
      }
    } else if (is_geometry(name)) {
      found.geometries.push_back(geometry(*each));
    }
  }
  return found;
}

class Collector {
 public:
  explicit Collector(KmlSource& source) : source_(source) {}

  // Depth is bounded by tinyxml2's limit on nested elements.
  void collect(const XMLElement& element) {
    const std::string_view name = local_name(element);
    if (name == "Placemark") {
      source_.placemarks.push_back(placemark(element));
    } else if (name == "Schema") {
      schema_names_.emplace(attribute(element, "id"), attribute(element, "name"));
    } else if (name == "NetworkLink") {
      collect_link(element);
    } else if (name == "kml" || name == "Document" || name == "Folder") {
      for (const auto* each = element.FirstChildElement(); each;
           each = each->NextSiblingElement()) {
        collect(*each);
      }
    }
  }

  // A <Schema> may stand after what refers to it, so names are resolved at the end.
  void resolve_schemas() {
    for (SourcePlacemark& each : source_.placemarks) {
      for (SourceData& data : each.data) {
        const std::size_t hash = data.schema_url.rfind('#');
        if (hash == std::string::npos) continue;
        data.schema = data.schema_url.substr(hash + 1);
        const auto named = schema_names_.find(data.schema);
        if (hash == 0 && named != schema_names_.end() && !named->second.empty()) {
          data.schema = named->second;
        }
        // The driver LIBKML of GDAL, and QGIS with it, write "#Route.schema" for a layer Route.
        constexpr std::string_view suffix = ".schema";
        if (data.schema.ends_with(suffix)) data.schema.resize(data.schema.size() - suffix.size());
      }
    }
  }

 private:
  void collect_link(const XMLElement& element) {
    const XMLElement* link = child(element, "Link");
    if (link == nullptr) link = child(element, "Url");
    const XMLElement* href = link == nullptr ? nullptr : child(*link, "href");
    if (href == nullptr) return;
    LinedText text = text_of(*href);
    if (text.text.find("://") != std::string::npos) return;
    source_.links.push_back({std::move(text.text), text.line});
  }

  KmlSource& source_;
  std::map<std::string, std::string> schema_names_;  // by id
};

std::string in_plain_words(const tinyxml2::XMLDocument& document) {
  switch (document.ErrorID()) {
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "is empty; a KML document is wanted";
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "is no XML: an element that starts here is not closed by its own end tag";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "is no XML: an attribute is not of the form name=\"value\", or a tag is not closed";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "is no XML: a comment is not closed by '-->'";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "is no XML: a CDATA section is not closed by ']]>'";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "is no XML: a declaration <? ... ?> is misplaced or not closed";
    case tinyxml2::XML_ERROR_PARSING_UNKNOWN:
      return "is no XML: a declaration <! ... > is not closed";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "is no XML: the document ends in the middle of a text";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return fmt::format("nests elements more than {} deep", TINYXML2_MAX_ELEMENT_DEPTH);
    default:
      return "is no XML: a tag is malformed (is a '<' meant that reads '&lt;' in XML?), or the "
             "document ends too early";
  }
}

// The one root element; throws unless it is one that KML documents have.
const XMLElement& root_of(const tinyxml2::XMLDocument& document, const std::string& file) {
  const XMLElement* root = document.RootElement();
  if (root == nullptr) throw InputError({file, 0}, "is no XML: there is no element");
  constexpr std::array<std::string_view, 4> roots{"kml", "Document", "Folder", "Placemark"};
  if (std::ranges::find(roots, local_name(*root)) == roots.end()) {
    throw InputError(
        {file, root->GetLineNum()},
        fmt::format("is no KML: its outermost element is <{}>, <kml> is wanted", root->Name()));
  }
  for (const auto* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if ((node->ToElement() != nullptr && node != root) || node->ToText() != nullptr) {
      throw InputError({file, node->GetLineNum()},
                       fmt::format("is no XML: there is more than the one <{}>", root->Name()));
    }
  }
  return *root;
}

}  // namespace

KmlSource parse_kml(std::string bytes, const std::string& file) {
  const KmlText text = kml_text(std::move(bytes), file);
  check_markup(text);
  tinyxml2::XMLDocument document;
  document.Parse(text.utf8.data(), text.utf8.size());
  if (document.Error()) {
    throw InputError({text.file, document.ErrorLineNum()}, in_plain_words(document));
  }
  KmlSource source{text.file, {}};
  Collector collector(source);
  collector.collect(root_of(document, text.file));
  collector.resolve_schemas();
  return source;
}

KmlSource read_kml(const std::string& file) { return parse_kml(read_bytes(file), file); }

}  // namespace lsos
