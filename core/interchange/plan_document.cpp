#include "interchange/plan_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "interchange/places.h"
#include "plan/kml_writer.h"

namespace lsos {

namespace {

// Colours of rovers' lines, which differ also for the colour-blind (Okabe and Ito, 2008), as
// alpha, blue, green, red.
constexpr std::array<std::string_view, 6> rover_colors{"ff00a5e6", "ffe9b456", "ff739e00",
                                                       "ffa779cc", "ff005ed5", "ff42e4f0"};

bool is_whole(const SourceGeometry& geometry) {
  const std::size_t places = tuples_of(geometry.coordinates).size();
  if (geometry.kind == "Point") return places == 1;
  if (geometry.kind == "LineString") return places >= 2;
  return geometry.kind == "Polygon" && places >= 3;
}

// The ring, ending where it begins.
std::string closed(const std::string& ring) {
  const std::vector<std::string> tuples = tuples_of(ring);
  return tuples.empty() || tuples.front() == tuples.back() ? ring : ring + " " + tuples.front();
}

KmlCoordinates kml_coordinates(const SourceGeometry& geometry) {
  KmlCoordinates found;
  if (geometry.kind != "Polygon") {
    found.kind = geometry.kind == "Point" ? KmlGeometryKind::point : KmlGeometryKind::line;
    found.outline = geometry.coordinates;
    return found;
  }
  found.kind = KmlGeometryKind::polygon;
  found.outline = closed(geometry.coordinates);
  for (const SourceGeometry::Ring& hole : geometry.holes) {
    found.holes.push_back(closed(hole.coordinates));
  }
  return found;
}

// Data of a Placemark. A feature of a layer has no SchemaData; its field Type, or the name of its
// layer, states its kind.
SourceData data_of(const SourcePlacemark& placemark) {
  if (!placemark.data.empty()) return placemark.data.front();
  SourceData data{"", placemark.folders.empty() ? "" : placemark.folders.back(), {}, 0};
  for (const SourceField& field : placemark.plain_data) {
    if (field.name == "Type") data.schema = field.text;
    if (field.name != "name") data.fields.push_back(field);
  }
  return data;
}

const std::string* value_named(const SourceData& data, const std::string& name) {
  const auto found = std::ranges::find(data.fields, name, &SourceField::name);
  return found == data.fields.end() ? nullptr : &found->text;
}

class DocumentMaker {
 public:
  explicit DocumentMaker(const DocumentLook& look) : look_(look) {}

  std::string write(const KmlSource& source) {
    document_.name = look_.name.empty() ? source.file : look_.name;
    document_.description = look_.description;
    document_.target = look_.target;
    for (const SourcePlacemark& from : source.placemarks) {
      KmlPlacemark placemark = placemark_of(from);
      std::vector<KmlPlacemark>* list = &document_.placemarks;
      std::vector<KmlFolder>* folders = &document_.folders;
      if (look_.has_folders) {
        for (const std::string& name : from.folders) {
          auto found = std::ranges::find(*folders, name, &KmlFolder::name);
          if (found == folders->end()) {
            folders->push_back({name, "", false, {}, {}});
            found = folders->end() - 1;
          }
          list = &found->placemarks;
          folders = &found->folders;
        }
      }
      list->push_back(std::move(placemark));
    }
    if (!look_.places.empty()) document_.folders.push_back({"Places", "", false, {}, {}});
    for (const SourcePlacemark& from : look_.places) {
      KmlPlacemark place;
      place.name = from.name;
      place.coordinates = kml_coordinates(from.geometries.front());
      document_.folders.back().placemarks.push_back(std::move(place));
    }
    return write_kml(document_);
  }

 private:
  KmlPlacemark placemark_of(const SourcePlacemark& from) {
    const SourceData data = data_of(from);
    const auto known = std::ranges::find(document_.schemas, data.schema, &KmlSchema::id);
    KmlSchema& schema =
        known != document_.schemas.end()
            ? *known
            : document_.schemas.emplace_back(KmlSchema{data.schema, data.schema, {}});
    KmlPlacemark placemark;
    placemark.name = from.name;
    placemark.description = from.description;
    placemark.schema_id = data.schema;
    const auto add = [&](const std::string& name, const std::string& text) {
      placemark.data.emplace_back(name, text);
      if (std::ranges::find(schema.fields, name, &KmlField::name) == schema.fields.end()) {
        schema.fields.push_back({name, "string", ""});
      }
    };
    // Map tools may rewrite schemaUrl; this field then still states the kind of the Placemark.
    if (look_.has_folders && value_named(data, "Type") == nullptr) add("Type", data.schema);
    for (const SourceField& field : data.fields) add(field.name, field.text);
    for (const SourceGeometry& geometry : from.geometries) {
      if (is_whole(geometry)) placemark.coordinates = kml_coordinates(geometry);
    }
    if (look_.has_folders) placemark.style_id = style_of(data);
    return placemark;
  }

  // The style of a rover's Placemarks; "" for others.
  std::string style_of(const SourceData& data) {
    const std::string* rover_id = value_named(data, "RoverId");
    if (rover_id == nullptr) return "";
    const auto found = std::ranges::find(rovers_, *rover_id);
    const auto index = static_cast<std::size_t>(found - rovers_.begin());
    if (found == rovers_.end()) {
      rovers_.push_back(*rover_id);
      KmlStyle style;
      style.id = fmt::format("rover{}", index + 1);
      style.line_color_abgr = rover_colors[index % rover_colors.size()];
      style.icon_color_abgr = style.line_color_abgr;
      style.line_width = 3;
      document_.styles.push_back(std::move(style));
    }
    return fmt::format("rover{}", index + 1);
  }

  DocumentLook look_;
  KmlDocument document_;
  std::vector<std::string> rovers_;
};

}  // namespace

std::string kml_of(const KmlSource& source, const DocumentLook& look) {
  return DocumentMaker(look).write(source);
}

}  // namespace lsos
