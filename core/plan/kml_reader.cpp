#include "plan/kml_reader.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "plan/kml_geometry.h"
#include "plan/kml_text.h"
#include "plan/kmz_archive.h"
#include "plan/layer_reader.h"

namespace lsos {

namespace {

using tinyxml2::XMLElement;

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

SourceField plain_data(const XMLElement& element) {
  const XMLElement* value = child(element, "value");
  LinedText text = value == nullptr ? LinedText{"", element.GetLineNum()} : text_of(*value);
  return {attribute(element, "name"), std::move(text.text), text.line};
}

// Reads a point from a Camera: GDAL's driver LIBKML, which QGIS uses, writes a point that has a
// field Heading so.
void take_camera(const XMLElement& camera, SourcePlacemark& placemark) {
  const auto text = [&](const char* name) {
    const XMLElement* part = child(camera, name);
    return part == nullptr ? LinedText{"", camera.GetLineNum()} : text_of(*part);
  };
  const LinedText longitude = text("longitude"), heading = text("heading");
  const std::string latitude = text("latitude").text;
  if (longitude.text.empty() || latitude.empty()) return;
  placemark.geometries.push_back({"Point", longitude.text + "," + latitude, longitude.line});
  placemark.is_from_camera = true;
  if (!heading.text.empty()) {
    placemark.plain_data.push_back({"Heading", heading.text, heading.line});
  }
}

SourcePlacemark placemark(const XMLElement& element) {
  SourcePlacemark found;
  const XMLElement* camera = nullptr;
  found.line = element.GetLineNum();
  for (const auto* each = element.FirstChildElement(); each; each = each->NextSiblingElement()) {
    const std::string_view name = local_name(*each);
    if (name == "name") {
      found.name = text_of(*each).text;
    } else if (name == "description") {
      found.description = text_of(*each).text;
    } else if (name == "ExtendedData") {
      for (const auto* data = each->FirstChildElement(); data; data = data->NextSiblingElement()) {
        if (local_name(*data) == "SchemaData") found.data.push_back(schema_data(*data));
        if (local_name(*data) == "Data") found.plain_data.push_back(plain_data(*data));
      }
    } else if (is_geometry(name) && !is_empty_multi(*each)) {
      found.geometries.push_back(read_kml_geometry(*each));
    } else if (name == "Camera") {
      camera = each;
    }
  }
  if (camera != nullptr && found.geometries.empty()) take_camera(*camera, found);
  return found;
}

SourceSchema schema(const XMLElement& element, const std::string& file) {
  SourceSchema found{file, attribute(element, "id"), attribute(element, "name"), {}};
  for (const auto* each = element.FirstChildElement(); each; each = each->NextSiblingElement()) {
    if (local_name(*each) != "SimpleField") continue;
    found.fields.push_back(
        {attribute(*each, "name"), attribute(*each, "type"), each->GetLineNum()});
  }
  return found;
}

// Collects the Placemarks, Schemas and links of one document.
class Collector {
 public:
  Collector(KmlSource& source, const std::string& file, std::vector<std::string> folders)
      : source_(source),
        file_(file),
        folders_(std::move(folders)),
        first_placemark_(source.placemarks.size()),
        first_schema_(source.schemas.size()) {}

  // The recursion depth is bounded by tinyxml2's limit on nested elements.
  void collect(const XMLElement& element) {
    const std::string_view name = local_name(element);
    if (name == "Placemark") {
      SourcePlacemark found = placemark(element);
      found.file = file_ == source_.file ? "" : file_;
      found.folders = folders_;
      source_.placemarks.push_back(std::move(found));
    } else if (name == "Schema") {
      source_.schemas.push_back(schema(element, file_));
    } else if (name == "NetworkLink") {
      collect_link(element);
    } else if (name == "kml" || name == "Document" || name == "Folder") {
      const XMLElement* title = name == "kml" ? nullptr : child(element, "name");
      if (title != nullptr) folders_.push_back(text_of(*title).text);
      for (const auto* each = element.FirstChildElement(); each;
           each = each->NextSiblingElement()) {
        collect(*each);
      }
      if (title != nullptr) folders_.pop_back();
    }
  }

  // Resolves the names of schemas. Called last, because a <Schema> may follow what refers to it.
  void resolve_schemas() {
    std::map<std::string, std::string> names;  // by id
    for (std::size_t i = first_schema_; i < source_.schemas.size(); ++i) {
      names.emplace(source_.schemas[i].id, source_.schemas[i].name);
    }
    for (std::size_t i = first_placemark_; i < source_.placemarks.size(); ++i) {
      for (SourceData& data : source_.placemarks[i].data) {
        const std::size_t hash = data.schema_url.rfind('#');
        if (hash == std::string::npos) continue;
        data.schema = data.schema_url.substr(hash + 1);
        const auto named = names.find(data.schema);
        if (hash == 0 && named != names.end() && !named->second.empty()) {
          data.schema = named->second;
        }
        // GDAL's driver LIBKML, which QGIS uses, writes "#Route.schema" for a layer Route.
        constexpr std::string_view suffix = ".schema";
        if (data.schema.ends_with(suffix)) data.schema.resize(data.schema.size() - suffix.size());
      }
    }
  }

  // A NetworkLink to a file, and the folders that it lies in.
  struct Link {
    KmlSource::Link link;
    std::vector<std::string> folders;
  };
  const std::vector<Link>& links() const { return links_; }

 private:
  void collect_link(const XMLElement& element) {
    const XMLElement* link = child(element, "Link");
    if (link == nullptr) link = child(element, "Url");
    const XMLElement* href = link == nullptr ? nullptr : child(*link, "href");
    if (href == nullptr) return;
    LinedText text = text_of(*href);
    if (text.text.find("://") != std::string::npos) return;
    links_.push_back({{file_, std::move(text.text), text.line}, folders_});
    if (const XMLElement* title = child(element, "name")) {
      links_.back().folders.push_back(text_of(*title).text);
    }
  }

  KmlSource& source_;
  const std::string& file_;
  std::vector<std::string> folders_;
  std::size_t first_placemark_, first_schema_;
  std::vector<Link> links_;
};

std::string parse_error_text(const tinyxml2::XMLDocument& document) {
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

// The root element. Throws InputError unless there is exactly one and KML documents may have it.
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

// Adds the contents of one document to the source and returns its links.
std::vector<Collector::Link> add_document(const KmlText& text, std::vector<std::string> folders,
                                          KmlSource& source) {
  check_markup(text);
  tinyxml2::XMLDocument document;
  document.Parse(text.utf8.data(), text.utf8.size());
  if (document.Error()) {
    throw InputError({text.file, document.ErrorLineNum()}, parse_error_text(document));
  }
  Collector collector(source, text.file, std::move(folders));
  collector.collect(root_of(document, text.file));
  collector.resolve_schemas();
  return collector.links();
}

// Reads the main document of an archive and the documents in it that are linked, in the order of
// the links.
KmlSource parse_kmz(const std::string& bytes, const std::string& file) {
  KmzArchive archive(bytes, file);
  const std::string root = archive.document_name();
  KmlSource source{archive.path(root), {}};
  std::set<std::string> seen{root};
  const auto add = [&](const auto& add_next, const std::string& name,
                       std::vector<std::string> folders) -> void {
    for (Collector::Link& each : add_document(kml_text(archive.unpacked(name), archive.path(name)),
                                              std::move(folders), source)) {
      const std::string linked = archive.resolved(each.link.href, name);
      if (linked.empty()) {
        source.links.push_back(std::move(each.link));
      } else if (seen.insert(linked).second) {
        add_next(add_next, linked, std::move(each.folders));
      }
    }
  };
  add(add, root, {});
  return source;
}

}  // namespace

KmlSource parse_kml(std::string bytes, const std::string& file) {
  if (is_zip(bytes)) return parse_kmz(bytes, file);
  KmlSource source{file, {}};
  for (Collector::Link& each : add_document(kml_text(std::move(bytes), file), {}, source)) {
    source.links.push_back(std::move(each.link));
  }
  return source;
}

KmlSource parse_plan(std::string bytes, const std::string& file) {
  return is_geopackage(bytes) ? read_layers(file) : parse_kml(std::move(bytes), file);
}

KmlSource read_kml(const std::string& file) { return parse_kml(read_bytes(file), file); }

}  // namespace lsos
