#include "plan/kml_writer.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>

#include "base/error.h"
#include "base/visible_text.h"

namespace lsos {

namespace {

// Writes elements in the order that the KML 2.2 schema requires.
class Writer {
 public:
  std::string document(const KmlDocument& document) {
    printer_.PushHeader(false, true);
    open("kml");
    printer_.PushAttribute("xmlns", "http://www.opengis.net/kml/2.2");
    printer_.PushAttribute("xmlns:gx", "http://www.google.com/kml/ext/2.2");
    if (!document.target.empty()) attribute("hint", "target=" + document.target);
    open("Document");
    element("name", document.name);
    optional_element("description", document.description);
    if (document.look_at) look_at(*document.look_at);
    for (const KmlStyle& each : document.styles) style(each);
    for (const KmlSchema& each : document.schemas) schema(each);
    for (const KmlFolder& each : document.folders) folder(each);
    for (const KmlPlacemark& each : document.placemarks) placemark(each);
    close();
    close();
    return printer_.CStr();
  }

 private:
  // Only elements that people look for begin a line: indentation of all others took up half of an
  // overlay file.
  void open(const char* name) {
    constexpr std::array<std::string_view, 6> of_a_line{"Document", "Folder", "Placemark",
                                                        "Style",    "Schema", "SimpleField"};
    printer_.OpenElement(name, std::ranges::find(of_a_line, name) == of_a_line.end());
  }
  void close() { printer_.CloseElement(true); }
  void attribute(const char* name, const std::string& value) {
    printer_.PushAttribute(name, xml_text(value).c_str());
  }
  void element(const char* name, const std::string& text) {
    open(name);
    if (!text.empty()) printer_.PushText(xml_text(text).c_str());
    close();
  }
  void optional_element(const char* name, const std::string& text) {
    if (!text.empty()) element(name, text);
  }

  // HTML is written as CDATA, which keeps a table readable and a third shorter.
  void description(const std::string& text) {
    const bool is_html = text.starts_with('<') && text.find("]]>") == std::string::npos;
    if (!is_html) return optional_element("description", text);
    open("description");
    printer_.PushText(xml_text(text).c_str(), true);
    close();
  }

  void look_at(const KmlLookAt& from) {
    open("LookAt");
    element("longitude", fmt::format("{:.6f}", lon_deg(from.place)));
    element("latitude", fmt::format("{:.6f}", lat_deg(from.place)));
    element("altitude", "0");
    element("heading", "0");
    element("tilt", "0");
    element("range", fmt::format("{:.0f}", from.range_m));
    close();
  }

  void style(const KmlStyle& style) {
    open("Style");
    attribute("id", style.id);
    if (!style.icon_color_abgr.empty()) {
      open("IconStyle");
      element("color", style.icon_color_abgr);
      element("scale", fmt::format("{}", style.icon_scale));
      if (!style.icon_href.empty()) {
        open("Icon");
        element("href", style.icon_href);
        close();
      }
      close();
    }
    open("LabelStyle");
    element("scale", fmt::format("{}", style.label_scale));
    close();
    if (!style.line_color_abgr.empty()) {
      open("LineStyle");
      element("color", style.line_color_abgr);
      element("width", fmt::format("{}", style.line_width));
      close();
    }
    if (!style.balloon_text.empty()) {
      open("BalloonStyle");
      element("text", style.balloon_text);
      close();
    }
    close();
  }

  void schema(const KmlSchema& schema) {
    open("Schema");
    attribute("name", schema.name);
    attribute("id", schema.id);
    for (const KmlField& each : schema.fields) field("SimpleField", each);
    for (const KmlField& each : schema.array_fields) field("gx:SimpleArrayField", each);
    close();
  }

  void field(const char* kind, const KmlField& field) {
    open(kind);
    attribute("type", field.type);
    attribute("name", field.name);
    optional_element("displayName", field.display_name);
    close();
  }

  void folder(const KmlFolder& folder_to_write) {
    open("Folder");
    element("name", folder_to_write.name);
    if (folder_to_write.open) element("open", "1");
    description(folder_to_write.description);
    for (const KmlFolder& each : folder_to_write.folders) folder(each);
    for (const KmlPlacemark& each : folder_to_write.placemarks) placemark(each);
    close();
  }

  void placemark(const KmlPlacemark& placemark) {
    open("Placemark");
    element("name", placemark.name);
    description(placemark.description);
    time(placemark);
    if (!placemark.style_id.empty()) element("styleUrl", "#" + placemark.style_id);
    if (placemark.icon_heading_deg) {
      open("Style");
      open("IconStyle");
      element("heading", fmt::format("{:.0f}", *placemark.icon_heading_deg));
      close();
      close();
    }
    const bool is_track = !placemark.track.points.empty();
    if (!placemark.schema_id.empty() && !is_track) data(placemark);
    if (is_track) {
      track(placemark);
    } else if (placemark.coordinates.kind != KmlGeometryKind::none) {
      geometry(placemark.coordinates);
    } else {
      geometry(placemark.geometry);
    }
    close();
  }

  void track(const KmlPlacemark& placemark) {
    const KmlTrack& track = placemark.track;
    LSOS_ASSERT(track.when_utc.size() == track.points.size());
    open("gx:Track");
    element("altitudeMode", "clampToGround");
    for (const std::string& utc : track.when_utc) element("when", utc);
    for (const Geodetic& point : track.points) {
      element("gx:coord", fmt::format("{:.9f} {:.9f} 0", lon_deg(point), lat_deg(point)));
    }
    if (!track.arrays.empty()) {
      open("ExtendedData");
      open("SchemaData");
      attribute("schemaUrl", "#" + placemark.schema_id);
      for (const auto& [name, texts] : track.arrays) {
        LSOS_ASSERT(texts.size() == track.points.size());
        open("gx:SimpleArrayData");
        attribute("name", name);
        for (const std::string& text : texts) element("gx:value", text);
        close();
      }
      close();
      close();
    }
    close();
  }

  void time(const KmlPlacemark& placemark) {
    if (!placemark.when_utc.empty()) {
      open("TimeStamp");
      element("when", placemark.when_utc);
      close();
    } else if (!placemark.begin_utc.empty() || !placemark.end_utc.empty()) {
      open("TimeSpan");
      optional_element("begin", placemark.begin_utc);
      optional_element("end", placemark.end_utc);
      close();
    }
  }

  void data(const KmlPlacemark& placemark) {
    open("ExtendedData");
    open("SchemaData");
    attribute("schemaUrl", "#" + placemark.schema_id);
    for (const auto& [name, text] : placemark.data) {
      open("SimpleData");
      attribute("name", name);
      if (!text.empty()) printer_.PushText(xml_text(text).c_str());
      close();
    }
    close();
    close();
  }

  void geometry(const KmlGeometry& geometry) {
    if (geometry.kind == KmlGeometryKind::none) return;
    const bool is_point = geometry.kind == KmlGeometryKind::point;
    const bool is_polygon = geometry.kind == KmlGeometryKind::polygon;
    LSOS_ASSERT(is_point ? geometry.points.size() == 1
                         : geometry.points.size() >= (is_polygon ? 3U : 2U));
    open(is_point ? "Point" : is_polygon ? "Polygon" : "LineString");
    if (!is_point && geometry.clamp_to_ground) element("tessellate", "1");
    element("altitudeMode", geometry.clamp_to_ground ? "clampToGround" : "absolute");
    if (!is_polygon) {
      coordinates(geometry, geometry.points);
    } else {
      boundary("outerBoundaryIs", geometry, geometry.points);
      for (const auto& hole : geometry.holes) boundary("innerBoundaryIs", geometry, hole);
    }
    close();
  }

  void boundary(const char* name, const KmlGeometry& geometry, std::vector<Geodetic> ring) {
    ring.push_back(ring.front());
    open(name);
    open("LinearRing");
    coordinates(geometry, ring);
    close();
    close();
  }

  void geometry(const KmlCoordinates& written) {
    const bool is_point = written.kind == KmlGeometryKind::point;
    const bool is_polygon = written.kind == KmlGeometryKind::polygon;
    open(is_point ? "Point" : is_polygon ? "Polygon" : "LineString");
    if (!is_point) element("tessellate", "1");
    element("altitudeMode", "clampToGround");
    if (!is_polygon) {
      element("coordinates", written.outline);
    } else {
      boundary("outerBoundaryIs", written.outline);
      for (const std::string& hole : written.holes) boundary("innerBoundaryIs", hole);
    }
    close();
  }

  void boundary(const char* name, const std::string& ring) {
    open(name);
    open("LinearRing");
    element("coordinates", ring);
    close();
    close();
  }

  void coordinates(const KmlGeometry& geometry, const std::vector<Geodetic>& points) {
    std::string text;
    for (const Geodetic& point : points) {
      LSOS_ASSERT(std::isfinite(point.lon_rad) && std::isfinite(point.lat_rad));
      // 1e-9 degrees are 0.1 mm on Earth.
      text +=
          fmt::format("{}{:.9f},{:.9f}", text.empty() ? "" : " ", lon_deg(point), lat_deg(point));
      if (!geometry.clamp_to_ground) {
        LSOS_ASSERT(std::isfinite(point.height_m));
        text += fmt::format(",{:.3f}", point.height_m);
      }
    }
    element("coordinates", text);
  }

  tinyxml2::XMLPrinter printer_;
};

}  // namespace

std::string target_of(const Body& body) {
  if (body.id == BodyId::earth) return "";
  std::string name(body.name);
  name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
  return name;
}

std::string write_kml(const KmlDocument& document) { return Writer().document(document); }

}  // namespace lsos
