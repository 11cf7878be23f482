// Declarations and plan text that the tests of this folder share.
#pragma once

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "plan/plan.h"

namespace lsos::test {

using Fields = std::vector<std::pair<std::string, std::string>>;

inline FieldDeclaration number_field(const char* name, const char* key, const char* unit,
                                     double min_si) {
  FieldDeclaration field;
  field.name = name;
  field.key = key;
  field.kind = FieldKind::number;
  field.unit = find_unit(unit);
  field.min_si = min_si;
  return field;
}

inline FieldDeclaration required_field(const char* name, const char* key, FieldKind kind) {
  FieldDeclaration field;
  field.name = name;
  field.key = key;
  field.kind = kind;
  field.is_required = true;
  if (kind == FieldKind::duration) field.min_si = 0;
  return field;
}

// Declares the events Route, Wait and Pause, rover type SEV, and terrains Craters, Flat, Slope.
inline Declarations declarations() {
  Declarations known;
  EventDeclaration route;
  route.name = "Route";
  route.fields = {number_field("Speed", "speed_mps", "m/s", 0.05),
                  number_field("ArrivalRadius", "arrival_radius_m", "m", 0.01)};
  route.fields[0].default_value = 1.0;
  route.fields[1].default_value = 0.5;
  route.geometries = {GeometryKind::line, GeometryKind::point};
  route.drives = true;
  EventDeclaration wait;
  wait.name = "Wait";
  wait.fields = {required_field("Until", "until", FieldKind::utc)};
  wait.geometries = {GeometryKind::none, GeometryKind::point};
  EventDeclaration pause;
  pause.name = "Pause";
  pause.fields = {required_field("Duration", "duration_s", FieldKind::duration)};
  pause.geometries = {GeometryKind::none, GeometryKind::point};
  for (const EventDeclaration& each : {route, wait, pause}) known.events[each.name] = each;
  known.rover_types["SEV"].configurations = {"high", "low"};
  known.terrains = {"Craters", "Flat", "Slope"};
  return known;
}

inline std::string placemark(const std::string& name, const std::string& schema_url,
                             const Fields& fields, const std::string& geometry = "") {
  std::string text = "<Placemark>";
  if (!name.empty()) text += "<name>" + name + "</name>";
  text += "<ExtendedData><SchemaData schemaUrl=\"" + schema_url + "\">\n";
  for (const auto& [field, value] : fields) {
    text += "<SimpleData name=\"" + field + "\">" + value + "</SimpleData>\n";
  }
  return text + "</SchemaData></ExtendedData>" + geometry + "</Placemark>\n";
}

inline std::string point(const std::string& coordinates = "31,20") {
  return "<Point><coordinates>" + coordinates + "</coordinates></Point>";
}

inline std::string line(const std::string& coordinates = "31,20 31.001,20.002") {
  return "<LineString><coordinates>" + coordinates + "</coordinates></LineString>";
}

inline std::string mission(const Fields& more = {}) {
  Fields fields{{"Planet", "Moon"}, {"StartTime", "2026-07-01T00:00:00Z"}, {"Terrain", "Flat"}};
  fields.insert(fields.end(), more.begin(), more.end());
  return placemark("", "#MissionInfo", fields);
}

inline std::string rover(const std::string& id = "A", const Fields& more = {}) {
  Fields fields{{"RoverId", id}, {"RoverType", "SEV"}};
  fields.insert(fields.end(), more.begin(), more.end());
  return placemark("", "#Rover", fields, point());
}

inline std::string event(const std::string& type, const std::string& name,
                         const std::string& rover_id, int sequence, const Fields& more = {},
                         const std::string& geometry = "") {
  Fields fields{{"RoverId", rover_id}, {"Sequence", std::to_string(sequence)}};
  fields.insert(fields.end(), more.begin(), more.end());
  return placemark(name, "#" + type, fields, geometry);
}

inline std::string pause(const std::string& name, const std::string& rover_id, int sequence,
                         Fields more = {}) {
  more.emplace_back("Duration", "10");
  return event("Pause", name, rover_id, sequence, more);
}

inline std::string document(const std::string& placemarks) {
  return "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n" + placemarks +
         "</Document></kml>\n";
}

// Writes a file with these bytes, named after the running test, and returns its path.
inline std::string write_file(const std::string& bytes, const std::string& ending = "plan.kml") {
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  std::string file =
      ::testing::TempDir() + "lsos_" + info->test_suite_name() + "_" + info->name() + "_" + ending;
  for (char& c : file) {
    if (c == ' ') c = '_';
  }
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

// The faults of reading a plan, one per line, without the folder of the file.
inline std::string faults_text(const Faults& faults) {
  std::string text;
  for (Fault fault : faults.sorted()) {
    fault.place.file.erase(0, fault.place.file.rfind('/') + 1);
    text += to_string(fault) + "\n";
  }
  return text;
}

}  // namespace lsos::test
