// Writes KML 2.2 documents that are valid against the OGC schema and Google's extension of it
// (gx:Track), from plain values.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planet/body.h"

namespace lsos {

struct KmlField {
  std::string name;
  std::string type;  // string, int, uint, short, ushort, float, double, bool
  std::string display_name;
};

struct KmlSchema {
  std::string id;
  std::string name;
  std::vector<KmlField> fields;
  std::vector<KmlField> array_fields = {};  // of tracks: one value per moment
};

// Colours are eight hexadecimal digits: alpha, blue, green, red ("ff0000ff" is opaque red).
struct KmlStyle {
  std::string id;
  std::string line_color_abgr;  // "": no LineStyle
  double line_width = 2;        // pixels
  std::string icon_color_abgr;  // "": no IconStyle
  double icon_scale = 1;
  std::string icon_href;  // "": the viewer's own icon
  double label_scale = 1;
  std::string balloon_text;  // HTML; $[schema/field] stands for a value; "": viewer's own
};

enum class KmlGeometryKind { none, point, line, polygon };

struct KmlGeometry {
  KmlGeometryKind kind = KmlGeometryKind::none;
  // One for a point, two or more for a line, three or more corners for a polygon, each once.
  std::vector<Geodetic> points;
  // false: the points' heights are written, above the reference surface (KML "absolute").
  bool clamp_to_ground = true;
  // Corners of a polygon's holes, each once.
  std::vector<std::vector<Geodetic>> holes = {};
};

// A geometry whose coordinates are KML text already ("lon,lat lon,lat"), so that not a bit of them
// changes. Rings of a polygon end where they begin.
struct KmlCoordinates {
  KmlGeometryKind kind = KmlGeometryKind::none;
  std::string outline;
  std::vector<std::string> holes = {};
};

// Places in order of time, along which a viewer moves an icon.
struct KmlTrack {
  std::vector<std::string> when_utc;  // ISO 8601
  std::vector<Geodetic> points;       // one per moment, on the ground
  // Names of the schema's array fields, each with one text per moment.
  std::vector<std::pair<std::string, std::vector<std::string>>> arrays;
};

struct KmlPlacemark {
  std::string name;
  std::string description;  // "": none
  std::string style_id;     // "": none
  std::string when_utc;     // ISO 8601: a TimeStamp; "": none
  std::string begin_utc;    // with end_utc: a TimeSpan, either end may be ""; not with when_utc
  std::string end_utc;
  std::optional<double> icon_heading_deg;  // clockwise from north
  KmlGeometry geometry;
  KmlCoordinates coordinates = {};  // replaces the geometry unless its kind is `none`
  KmlTrack track;                   // replaces the geometry when it has points
  std::string schema_id;            // a schema of the document; "": no data
  std::vector<std::pair<std::string, std::string>> data;  // field name, text
};

struct KmlFolder {
  std::string name;
  std::string description = {};  // "": none
  bool open = false;
  std::vector<KmlPlacemark> placemarks;
  std::vector<KmlFolder> folders;
};

// View from above that a viewer shows when it opens the document.
struct KmlLookAt {
  Geodetic place;
  double range_m = 1000;
};

struct KmlDocument {
  std::string name;
  std::string description;  // "": none
  std::string target;       // body that Google Earth shows it on: "moon", "mars"; "": the Earth
  std::optional<KmlLookAt> look_at;
  std::vector<KmlSchema> schemas;
  std::vector<KmlStyle> styles;
  std::vector<KmlFolder> folders;
  std::vector<KmlPlacemark> placemarks;
};

// Google Earth's name of a body; "" for the Earth.
std::string target_of(const Body& body);

// The document as UTF-8 text. Characters that XML cannot hold become U+FFFD.
std::string write_kml(const KmlDocument& document);

struct PackedFile {
  std::string name;  // in the archive, with its folders: "icons/arrow.png"
  std::string bytes;
};
// Packs a KMZ archive of the document and the files it refers to. Throws std::runtime_error when
// memory runs out.
std::string pack_kmz(const std::string& kml, const std::vector<PackedFile>& others = {});
// Packs an archive. Equal files give equal bytes.
std::string pack_zip(const std::vector<PackedFile>& files);

}  // namespace lsos
