// Drives each shipped rover, and writes rovers/MEASURED.md and a picture of each.

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "rovers/page.h"

namespace lsos::rovers {
namespace {

namespace fs = std::filesystem;

std::string machine() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    return line.substr(line.find(':') + 2);
  }
  return "machine";
}

std::string placemark(const std::string& schema, const std::string& fields,
                      const std::string& geometry) {
  std::string text =
      fmt::format("<Placemark><ExtendedData><SchemaData schemaUrl=\"#{}\">", schema) + fields;
  return text + "</SchemaData></ExtendedData>" + geometry + "</Placemark>\n";
}

std::string field(const std::string& name, const std::string& value) {
  return fmt::format("<SimpleData name=\"{}\">{}</SimpleData>", name, value);
}

// A short drive in the morning, with the Sun some 30 degrees high.
std::string plan(const Subject& subject) {
  const std::string from = "<Point><coordinates>10,20</coordinates></Point>";
  const std::string to = "<Point><coordinates>10.00005,20.0002</coordinates></Point>";
  return "<kml xmlns=\"http://www.opengis.net/kml/2.2\"><Document>\n" +
         placemark("MissionInfo",
                   field("Planet", subject.planet) + field("Terrain", subject.terrain) +
                       field("StartTime",
                             subject.planet == std::string("Earth")  ? "2026-06-30T08:30:00Z"
                             : subject.planet == std::string("Mars") ? "2026-07-30T05:00:00Z"
                                                                     : "2026-07-24T12:00:00Z"),
                   "") +
         placemark("Rover", field("RoverId", "R") + field("RoverType", subject.rover), from) +
         placemark("Route", field("RoverId", "R") + field("Sequence", "1"), to) +
         "</Document></kml>\n";
}

void run(const std::string& arguments) {
  const std::string command = fmt::format("'{}' {} > /dev/null", LSOS_HOST, arguments);
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

void draw(const Subject& subject) {
  const fs::path folder = fs::temp_directory_path() / fmt::format("lsos-rovers-{}", subject.rover);
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::ofstream(folder / "plan.kml") << plan(subject);
  const fs::path picture = fs::path(LSOS_SOURCE_DIR) / picture_path(subject);
  fs::create_directories(picture.parent_path());
  run(fmt::format("'{0}/plan.kml' -o '{0}/run' --quiet", folder.string()));
  run(fmt::format("picture '{}/run' --at 5 --from chase --size 800 -o '{}' --quiet",
                  folder.string(), picture.string()));
  fs::remove_all(folder);
}

void write() {
  std::vector<Figures> figures;
  std::vector<double> times;
  for (const Subject& subject : subjects) {
    fmt::print("{}\n", subject.rover);
    figures.push_back(measure(subject));
    times.push_back(times_real_time(subject));
    draw(subject);
  }
  std::ofstream(fs::path(LSOS_SOURCE_DIR) / "rovers/MEASURED.md", std::ios::binary)
      << page(figures) << speed_part(machine(), times);
}

}  // namespace
}  // namespace lsos::rovers

int main() {
  try {
    lsos::rovers::write();
  } catch (const std::exception& e) {
    fmt::print(stderr, "write_rovers: {}\n", e.what());
    return 1;
  }
  return 0;
}
