#include "system/plan_text.h"

#include <algorithm>

namespace lsos::test {

namespace {

std::string placemark(const Mark& mark) {
  std::string text = "<Placemark>";
  if (!mark.name.empty()) text += "<name>" + mark.name + "</name>";
  text += "<ExtendedData><SchemaData schemaUrl=\"#" + mark.type + "\">\n";
  for (const auto& [name, value] : mark.fields) {
    text += "  <SimpleData name=\"" + name + "\">" + value + "</SimpleData>\n";
  }
  return text + "</SchemaData></ExtendedData>" + mark.geometry + "</Placemark>\n";
}

Fields joined(Fields fields, const Fields& more) {
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

}  // namespace

std::string kml(const std::vector<Mark>& marks) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n";
  for (const Mark& mark : marks) text += placemark(mark);
  return text + "</Document></kml>\n";
}

std::string point(const std::string& coordinates) {
  return "<Point><coordinates>" + coordinates + "</coordinates></Point>";
}

std::string line(const std::string& coordinates) {
  return "<LineString><coordinates>" + coordinates + "</coordinates></LineString>";
}

// Short missions log at full rate also while the rover is parked.
Mark mission(const Fields& more) {
  Fields fields = {{"Planet", "Moon"}, {"StartTime", "2026-01-01T00:00:00Z"}, {"Terrain", "Flat"}};
  std::string interval = "2";
  bool has_parked_interval = false;
  for (const auto& [name, text] : more) {
    if (name == "LogInterval") interval = text;
    has_parked_interval |= name == "ParkedLogInterval";
  }
  if (!has_parked_interval) fields.emplace_back("ParkedLogInterval", interval);
  return {"MissionInfo", joined(fields, more), ""};
}

Mark sev(const std::string& id, const std::string& coordinates) {
  return {"Rover", {{"RoverId", id}, {"RoverType", "SEV"}}, point(coordinates)};
}

Mark event(const std::string& type, const std::string& rover, int sequence, const Fields& more,
           const std::string& geometry) {
  const Fields fields = {{"RoverId", rover}, {"Sequence", std::to_string(sequence)}};
  return {type, joined(fields, more), geometry};
}

// A degree on the Moon's equator is 30323 m; 30 m are 0.000989 degrees.
std::vector<Mark> short_drive() {
  return {mission(), sev("SEV1", "0,0"),
          event("Route", "SEV1", 10, {{"Speed", "2"}}, line("0,0 0.000989,0")),
          event("Pause", "SEV1", 20, {{"Duration", "60"}}),
          event("Wait", "SEV1", 30, {{"Until", "2026-01-01T00:05:00Z"}})};
}

std::vector<Mark> two_rovers() {
  return {mission({{"LogInterval", "1"}}),
          sev("North", "0,0.0005"),
          sev("South", "0,-0.0005"),
          event("Route", "North", 1, {}, line("0,0.0005 0.001,0 0.0015,0")),
          event("Pause", "North", 2, {{"Duration", "20"}}),
          event("Pause", "South", 1, {{"Duration", "10"}, {"StartAfter", "North/1"}}),
          event("Route", "South", 2, {}, point("0.0005,-0.0007"))};
}

std::vector<Mark> long_drive() {
  std::string laps = "0,0";
  for (int lap = 0; lap < 50; ++lap) laps += " 0.03,0 0.03,0.03 0,0.03 0,0";
  return {mission(), sev("SEV1", "0,0"), event("Route", "SEV1", 1, {{"Speed", "2"}}, line(laps))};
}

}  // namespace lsos::test
