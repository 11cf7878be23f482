// overlay.kml from a small log, as KML and as GIS tools read it.
#include "product/overlay.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "base/files.h"
#include "picture/png.h"
#include "plan/kmz_archive.h"
#include "product/overlay_icons.h"
#include "product/rover_track.h"
#include "support/reference_data.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// Writes a log of two rovers: one drives along a line for `count` samples, "B" stands still.
void write_log(const std::string& file, int count) {
  LogWriter log(file, moon_crs, test_start());
  for (int i = 0; i < count; ++i) {
    SampleRow row = test_sample(i);
    log.write(row);
    row.rover_id = "SEV2";
    row.place = test_sample(0).place;
    log.write(row);
  }
  EventRow event = test_event();
  event.status = EventStatus::failed;
  event.reason = "stuck <deep> & fast";
  event.end = SimTime{5'000'000};
  event.place = test_sample(2).place;
  log.write(event);
  event.sequence = 15;
  event.label = "Pause 15";
  event.status = EventStatus::completed;
  log.write(event);
  event.sequence = 20;
  event.label = "Route 20";
  event.status = EventStatus::not_started;
  event.ready = event.start = event.end = std::nullopt;
  event.place = std::nullopt;
  log.write(event);
  log.write(NoteRow{SimTime{4'000'000}, "SEV1", 10, "reached", R"({"waypoint":2})",
                    test_sample(2).place});
  log.finish();
}

Plan test_plan() {
  Plan plan;
  plan.mission.planet = find_body("Moon");
  plan.mission.start_time = test_start();
  PlanEvent route;
  route.rover_id = "SEV1";
  route.sequence = 10;
  route.type = "Route";
  route.label = "Route 10";
  route.geometry = {GeometryKind::line,
                    {geodetic_from_degrees(-10.5, -89.25), geodetic_from_degrees(-10.4, -89.25)},
                    {},
                    7};
  plan.events = {route};
  return plan;
}

std::string overlay_of(const TestFolder& folder, int count) {
  write_log(folder / "log.gpkg", count);
  write_overlay(folder.path(), test_plan());
  return read_file(folder / "overlay.kml").value_or("");
}

std::string output_of(const std::string& command, const std::string& file) {
  const int status = std::system((command + " > '" + file + "' 2>&1").c_str());
  return read_file(file).value_or("") + (status == 0 ? "" : "[failed]");
}

bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null").c_str()) == 0;
}

TEST(Overlay, shows_what_was_planned_and_what_was_driven) {
  const TestFolder folder;
  const std::string kml = overlay_of(folder, 5);

  EXPECT_THAT(kml, HasSubstr("<name>SEV1 Route 10 (plan)</name>"));
  EXPECT_THAT(kml, HasSubstr("-10.500000000,-89.250000000 -10.400000000,-89.250000000"));
  EXPECT_THAT(kml, HasSubstr("<name>SEV1 driven</name>"));
  EXPECT_THAT(kml, HasSubstr("<color>ff0000ff</color>"));
  EXPECT_THAT(kml, HasSubstr("<color>ffff0000</color>"));
  EXPECT_EQ(count_of(kml, "<LineString>"), 2) << "SEV2 drew no line and drove none";
}

TEST(Overlay, shows_events_and_notes_where_they_happened) {
  const TestFolder folder;
  const std::string kml = overlay_of(folder, 5);

  EXPECT_THAT(kml, HasSubstr("<description><![CDATA[<table><tr><td>Status<td>failed<tr><td>Why<td>"
                             "stuck &lt;deep&gt; &amp; fast<tr>"));
  EXPECT_THAT(kml, HasSubstr("<styleUrl>#event-failed</styleUrl>"));
  EXPECT_THAT(kml, Not(HasSubstr("<styleUrl>#event-failed-unlabelled</styleUrl>")));
  EXPECT_THAT(kml, HasSubstr("<styleUrl>#event-completed-unlabelled</styleUrl>"))
      << "at the same place";
  EXPECT_THAT(kml, HasSubstr("<begin>2026-07-01T12:00:05.000Z</begin>")) << "its end";
  EXPECT_THAT(kml, HasSubstr("<SimpleData name=\"status\">not_started</SimpleData>"));
  EXPECT_THAT(kml, HasSubstr("<name>reached</name>"));
}

TEST(Overlay, carries_every_column_of_the_samples) {
  const TestFolder folder;
  const std::string kml = overlay_of(folder, 3);

  for (const char* name : {"time_s", "utc", "slip_max", "incidence", "phase"}) {
    EXPECT_THAT(kml, HasSubstr("name=\"" + std::string(name) + "\"/>")) << name;
  }
  EXPECT_THAT(kml, HasSubstr("<SimpleData name=\"speed_mps\">0.3</SimpleData>"));
  EXPECT_THAT(kml, HasSubstr("<SimpleData name=\"utc\">2026-07-01T12:00:04.000Z</SimpleData>"));
  EXPECT_THAT(kml, Not(HasSubstr("<SimpleData name=\"energy_j\">"))) << "not modelled: NULL";
  EXPECT_EQ(count_of(kml, "#lsos_samples"), 6);
}

TEST(Overlay, has_at_most_2000_samples_a_rover_evenly_along_its_drive) {
  const TestFolder folder;
  const std::string kml = overlay_of(folder, 5000);

  // 5000 rows, 0.6 m apart.
  const int samples = count_of(kml, "#lsos_samples");
  EXPECT_LE(samples, 2 * 2000);
  EXPECT_GT(samples, 2 * 1500);
  const std::regex name("<name>SEV1 ([0-9]+) s</name>");
  int last_s = 0;
  for (std::sregex_iterator at(kml.begin(), kml.end(), name), end; at != end; ++at) {
    const int time_s = std::stoi((*at)[1]);
    EXPECT_LE(time_s - last_s, 8) << "a spacing of 1.9 m and a row, at " << time_s;
    last_s = time_s;
  }
  EXPECT_EQ(last_s, 9998);
}

TEST(Overlay, has_a_track_that_a_time_slider_plays) {
  const TestFolder folder;
  const std::string kml = overlay_of(folder, 5000);

  EXPECT_EQ(count_of(kml, "<gx:Track>"), 2);
  EXPECT_LE(count_of(kml, "<gx:coord>"), 2 * 1500);
  EXPECT_GT(count_of(kml, "<gx:coord>"), 2 * 1000);
  EXPECT_THAT(kml, HasSubstr("<gx:SimpleArrayField type=\"float\" name=\"speed_mps\"/>"));
  const auto begin = kml.find("<gx:SimpleArrayData name=\"speed_mps\">");
  ASSERT_NE(begin, std::string::npos);
  const std::string array = kml.substr(begin, kml.find("</gx:SimpleArrayData>", begin) - begin);
  EXPECT_NEAR(2 * count_of(array, "<gx:value>"), count_of(kml, "<gx:coord>"), 10);
  EXPECT_THAT(array, HasSubstr("<gx:value>0.3</gx:value>"));
  EXPECT_THAT(kml, Not(HasSubstr("SimpleArrayData name=\"charge\""))) << "not modelled";
}

TEST(Overlay, says_of_a_sample_in_its_balloon_what_a_planner_asks) {
  const TestFolder folder;
  const std::string kml = overlay_of(folder, 3);
  EXPECT_THAT(kml, HasSubstr("<tr><td>Time<td>2026-07-01 12:00:04 UTC<tr>"));
  EXPECT_THAT(kml, HasSubstr("<tr><td>Speed<td>0.3 m/s<tr>"));
  EXPECT_THAT(kml, Not(HasSubstr("<td>Charge"))) << "not modelled";
}

TEST(Overlay, is_packed_on_request_the_same_each_time) {
  const TestFolder folder;
  overlay_of(folder, 50);
  write_packed_overlay(folder.path(), test_plan());
  const std::string packed = read_file(folder / "overlay.kmz").value_or("");
  EXPECT_LT(packed.size(), read_file(folder / "overlay.kml").value_or("").size() / 5);
  KmzArchive archive(packed, "overlay.kmz");
  std::string kml = archive.unpacked("doc.kml");
  // The archive contains the icons.
  for (const OverlayIcon icon : {OverlayIcon::arrow, OverlayIcon::disc, OverlayIcon::cross,
                                 OverlayIcon::square, OverlayIcon::diamond}) {
    EXPECT_TRUE(archive.unpacked(packed_icon(icon)).starts_with(png_mark)) << packed_icon(icon);
    EXPECT_THAT(kml, HasSubstr("<href>" + packed_icon(icon)));
    kml = std::regex_replace(kml, std::regex(packed_icon(icon)), server_icon(icon));
  }
  EXPECT_EQ(kml, read_file(folder / "overlay.kml"));
  EXPECT_EQ(packed.substr(10, 4), std::string("\0\0!\0", 4)) << "of 1980-01-01, 00:00:00";
  write_packed_overlay(folder.path(), test_plan());
  EXPECT_EQ(packed, read_file(folder / "overlay.kmz"));
  EXPECT_THROW(write_packed_overlay(folder / "none", test_plan()), InputError);
  std::filesystem::remove(folder / "overlay.kmz");
  std::filesystem::create_directory(folder / "overlay.kmz");
  EXPECT_THROW(write_packed_overlay(folder.path(), test_plan()), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "overlay.kmz"));
}

TEST(Overlay, is_valid_against_the_schema_of_kml) {
  LSOS_NEEDS_REFERENCE("kml/xsd/ogckml22.xsd");
  const std::string schema = reference_file("kml/xsd/ogckml22.xsd");
  if (!has_program("xmllint")) FAIL() << "no xmllint here";
  const TestFolder folder;
  overlay_of(folder, 5);
  // The catalog beside the schema names local copies of the schemas that it includes.
  const std::string catalog = schema.substr(0, schema.rfind('/')) + "/catalog.xml";
  const std::string command = "XML_CATALOG_FILES='" + catalog +
                              "' xmllint --nonet --noout --schema '" + schema + "' '" +
                              (folder / "overlay.kml") + "'";
  EXPECT_THAT(output_of(command, folder / "answer.txt"), HasSubstr("overlay.kml validates"));
}

TEST(Overlay, is_read_by_gis_tools_with_its_fields) {
  if (!has_program("ogrinfo")) FAIL() << "no ogrinfo here";
  const TestFolder folder;
  overlay_of(folder, 5);
  const std::string answer =
      output_of("ogrinfo -ro -al '" + (folder / "overlay.kml") + "'", folder / "answer.txt");

  EXPECT_THAT(answer, HasSubstr("Layer name: SEV1 samples"));
  EXPECT_THAT(answer, HasSubstr("speed_mps (Real) = 0.3"));
  EXPECT_THAT(answer, HasSubstr("Layer name: SEV1 events"));
  EXPECT_THAT(answer, HasSubstr("status (String) = failed"));
  EXPECT_THAT(answer, HasSubstr("sequence (Integer) = 10"));
  EXPECT_THAT(answer, HasSubstr("fields (String) = {\"waypoint\":2}"));
  EXPECT_THAT(answer, HasSubstr("LINESTRING"));
  EXPECT_THAT(answer, Not(HasSubstr("ERROR")));
}

TEST(Overlay, of_a_log_without_samples_has_no_rovers) {
  const TestFolder folder;
  LogWriter(folder / "log.gpkg", moon_crs, test_start()).finish();
  EXPECT_THAT(overlay_kml(LogReader(folder / "log.gpkg"), test_plan()), Not(HasSubstr("SEV1")));
}

TEST(SampleInterval, is_as_short_as_the_count_allows) {
  const SimTime s{1'000'000};
  EXPECT_EQ(sample_interval(100 * s, 2000, 2 * s, 2 * s), 2 * s);
  EXPECT_EQ(sample_interval(3998 * s, 2000, 2 * s, 2 * s), 2 * s);
  EXPECT_EQ(sample_interval(4000 * s, 2000, 2 * s, 2 * s), 4 * s);
  EXPECT_EQ(sample_interval(SimTime{0}, 2000, 2 * s, 2 * s), 2 * s);
}

TEST(SampleInterval, falls_on_the_rows_of_parked_rovers) {
  const SimTime s{1'000'000};
  // For four weeks 1210.2 s would suffice; 1260 s are 21 parked intervals.
  EXPECT_EQ(sample_interval(28 * 86'400 * s, 2000, 2 * s, 60 * s), 1260 * s);
  // A parked interval of an hour would leave two samples of two hours.
  EXPECT_EQ(sample_interval(7200 * s, 2000, 2 * s, 3600 * s), 4 * s);
}

TEST(RoverTrack, has_a_line_that_ends_where_the_rover_stands) {
  const DriveMarks marks({11, 10, 2}, {}, "SEV1", 100);
  RoverTrack track(*find_body("Moon"), marks, marks, SimTime{2'000'000});
  for (int i = 0; i <= 10; ++i) {
    SampleRow row = test_sample(i);
    // 0.2 m per sample northwards on a sphere of the Moon's radius.
    const double step_rad = 0.2 / find_body("Moon")->equatorial_radius_m;
    row.place = {0.1, 0.2 + step_rad * i, 0};
    track.add(row);
  }
  const std::vector<Geodetic> line = track.line();
  // The points lie at 0, 0.6, 1.2, 1.8 and 2.0 m.
  ASSERT_EQ(line.size(), 5u);
  EXPECT_NEAR(surface_distance_m(*find_body("Moon"), line.front(), line.back()), 2.0, 1e-6);
}

}  // namespace
}  // namespace lsos
