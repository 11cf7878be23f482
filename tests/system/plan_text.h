// Small plans, written as a mission planner's map tool writes them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lsos::test {

using Fields = std::vector<std::pair<std::string, std::string>>;

// One Placemark of a plan.
struct Mark {
  std::string type;  // name in its schemaUrl
  Fields fields;
  std::string geometry;  // KML, or ""
  std::string name = {};
};

std::string kml(const std::vector<Mark>& marks);

// "<Point>..." and "<LineString>..." with coordinates "lon,lat lon,lat ..." in degrees.
std::string point(const std::string& coordinates);
std::string line(const std::string& coordinates);

// A mission on the Moon's `Flat` terrain from 2026-01-01; `more` fields are added.
Mark mission(const Fields& more = {});
Mark sev(const std::string& id, const std::string& coordinates);
Mark event(const std::string& type, const std::string& rover, int sequence, const Fields& more = {},
           const std::string& geometry = "");

// One SEV that drives 30 m eastwards, pauses for 60 s and waits until 5 minutes have passed.
std::vector<Mark> short_drive();
// Two SEVs whose routes cross, with events that wait for each other.
std::vector<Mark> two_rovers();
// Hours of driving, for tests that interrupt a run.
std::vector<Mark> long_drive();

}  // namespace lsos::test
