// What a KML document says, as plain values: its Placemarks with data and geometry, each with the
// file and line it came from. What the values mean is not known here.
#pragma once

#include <string>
#include <vector>

namespace lsos {

// One <SimpleData>, or one <Data> with its <value>: the text without the blanks around it.
struct SourceField {
  std::string name;
  std::string text;
  int line = 0;
  std::string column = {};  // of a spreadsheet's cell, "C"; "": none
};

// One <SchemaData>.
struct SourceData {
  std::string schema_url;
  std::string schema;  // after '#', through the document's <Schema id name>; "" without '#'
  std::vector<SourceField> fields;
  int line = 0;
};

struct SourceGeometry {
  // "Point", "LineString" (also a LinearRing or gx:Track), "Polygon", "MultiGeometry" (of several,
  // or none), "Model", ...
  std::string kind;
  // Coordinates of Point, LineString and a Polygon's outline: text as written, without blanks
  // around it.
  std::string coordinates;
  int line = 0;  // of the first coordinate; else of the geometry
  // A Polygon's holes (innerBoundaryIs).
  struct Ring {
    std::string coordinates;
    int line = 0;
  };
  std::vector<Ring> holes = {};
};

struct SourcePlacemark {
  std::string name;
  std::vector<SourceData> data;
  std::vector<SourceField> plain_data;     // <Data>: fields that name no Schema
  std::vector<std::string> folders;        // that it lies in, Documents too, the innermost last
  std::vector<SourceGeometry> geometries;  // more than one is not KML, but is seen
  int line = 0;
  std::string file = {};        // that the lines are of, where it is not the document's
  bool is_from_camera = false;  // its place, and a field Heading, stood in a Camera
  std::string description = {};
};

// One <Schema>: what types it gives to fields.
struct SourceSchema {
  std::string file;
  std::string id, name;
  struct Field {
    std::string name, type;
    int line = 0;
  };
  std::vector<Field> fields;
};

struct KmlSource {
  std::string file;  // for messages; with the document's name for a KMZ
  std::vector<SourcePlacemark> placemarks;
  std::vector<SourceSchema> schemas = {};
  // <NetworkLink>s to files that are not read: outside the document's own KMZ archive. Those with
  // an address (a scheme) are not among them.
  struct Link {
    std::string file;
    std::string href;
    int line = 0;
  };
  std::vector<Link> links = {};
  // The layers of a GeoPackage that have places.
  struct Layer {
    std::string file;
    std::string body;  // of its CRS; "": it has none
    bool is_geographic = true;
  };
  std::vector<Layer> layers = {};
};

}  // namespace lsos
