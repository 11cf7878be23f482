// overlay.kml from a small log, as KML and as GIS tools read it.
#include "product/overlay.h"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

#include "base/files.h"
#include "base/segment.h"
#include "picture/png.h"
#include "plan/kmz_archive.h"
#include "product/overlay_icons.h"
#include "product/rover_days.h"
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
  log.write(NoteRow{SimTime{5'000'000}, "SEV1", 10, "warn_when", R"({"condition":"charge < 0.3"})",
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

// Writes a log of three days; `rovers` drive all the time.
void write_days_log(const std::string& file, int rovers, int rows) {
  LogWriter log(file, moon_crs, test_start());
  for (int i = 0; i < rows; ++i) {
    SampleRow row = test_sample(i);
    row.time = 3 * day_length * i / (rows - 1);
    for (int k = 1; k <= rovers; ++k) {
      row.rover_id = fmt::format("SEV{}", k);
      log.write(row);
    }
  }
  EventRow event = test_event();
  event.start = day_length;
  event.end = day_length + SimTime{60'000'000};
  event.place = test_sample(2).place;
  log.write(event);
  event.sequence = 20;
  event.label = "Never begun";
  event.status = EventStatus::not_started;
  event.ready = event.start = event.end = std::nullopt;
  log.write(event);
  log.finish();
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
  EXPECT_THAT(kml, HasSubstr("</description><TimeSpan><begin>2026-07-01T12:00:05.000Z</begin>"
                             "</TimeSpan><styleUrl>#note-warning</styleUrl>"))
      << "a warning, red";
  EXPECT_THAT(kml, HasSubstr("<Style id=\"note-warning\"><IconStyle><color>ff1c19d7</color>"));
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
  EXPECT_THAT(kml, HasSubstr(" samples; log.gpkg has all</description>"));
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
  const std::string days = folder / "days";
  std::filesystem::create_directory(days);
  overlay_of(folder, 5);
  write_days_log(days + "/log.gpkg", 1, 50);
  write_overlay(days, test_plan());
  // The catalog beside the schema names local copies of the schemas that it includes.
  const std::string catalog = schema.substr(0, schema.rfind('/')) + "/catalog.xml";
  const std::string command = "XML_CATALOG_FILES='" + catalog +
                              "' xmllint --nonet --noout --schema '" + schema + "' '" +
                              (folder / "overlay.kml") + "' '" + days + "/overlay.kml'";
  const std::string answer = output_of(command, folder / "answer.txt");
  EXPECT_EQ(count_of(answer, "overlay.kml validates"), 2) << answer;
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

TEST(Overlay, of_several_days_has_a_folder_for_each) {
  if (!has_program("ogrinfo")) FAIL() << "no ogrinfo here";
  const TestFolder folder;
  write_days_log(folder / "log.gpkg", 2, 301);
  write_overlay(folder.path(), test_plan());
  const std::string kml = read_file(folder / "overlay.kml").value_or("");

  EXPECT_THAT(kml, HasSubstr("<name>SEV1 day 3</name><description>2026-07-03 12:00 to 2026-07-04 "
                             "12:00 UTC</description>"));
  EXPECT_THAT(kml, Not(HasSubstr("SEV1 day 4"))) << "the last sample ends the third day";
  // The second day's line appears with it.
  EXPECT_THAT(kml, HasSubstr("<begin>2026-07-02T12:00:00.000Z</begin>"));
  const std::string answer =
      output_of("ogrinfo -ro -al -so '" + (folder / "overlay.kml") + "'", folder / "answer.txt");
  EXPECT_THAT(answer, Not(HasSubstr("ERROR")));
  const auto features = [&](const std::string& layer) {
    const std::regex count("Layer name: " + layer + "\n(?:[^\n]*\n){0,2}?Feature Count: ([0-9]+)");
    std::smatch found;
    return std::regex_search(answer, found, count) ? std::stoi(found[1]) : -1;
  };
  EXPECT_EQ(features("SEV1 day 1 samples"), 100) << "at 0 h, 0.24 h, ..., 23.76 h";
  EXPECT_EQ(features("SEV1 day 2 samples"), 100);
  EXPECT_EQ(features("SEV2 day 3 samples"), 101);
  EXPECT_EQ(features("SEV1 day 1 driven"), 1);
  EXPECT_EQ(features("SEV1 day 1 events"), -1) << "none on that day";
  EXPECT_EQ(features("SEV1 day 2 events"), 1);
  EXPECT_EQ(features("SEV1 events"), 1) << "never begun";
}

TEST(Overlay, of_many_rovers_has_at_most_4000_samples) {
  const TestFolder folder;
  write_days_log(folder / "log.gpkg", 4, 1500);
  write_overlay(folder.path(), test_plan());
  const std::string kml = read_file(folder / "overlay.kml").value_or("");
  EXPECT_LE(count_of(kml, "#lsos_samples"), 4000);
  EXPECT_GT(count_of(kml, "#lsos_samples"), 3000);
  EXPECT_GT(count_of(kml, "<name>SEV4 "), 700);
  EXPECT_LT(kml.size(), 2700u * 4000) << "2.7 kB a sample";
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
  const std::vector<RoverTrack::Piece> driven = track.driven();
  ASSERT_EQ(driven.size(), 1u);
  // A straight drive needs its ends alone.
  const std::vector<Geodetic>& line = driven.front().line;
  ASSERT_EQ(line.size(), 2u);
  EXPECT_NEAR(surface_distance_m(*find_body("Moon"), line.front(), line.back()), 2.0, 1e-6);
}

TEST(RoverTrack, is_cut_by_day_and_stays_near_every_place_that_was_passed) {
  const Body& moon = *find_body("Moon");
  const double radius_m = moon.equatorial_radius_m;
  const DriveMarks marks({400, 400, 4000}, {}, "SEV1", 100);
  RoverTrack track(moon, marks, marks, SimTime{2'000'000}, day_length);
  std::vector<Geodetic> passed;
  for (int i = 0; i < 400; ++i) {
    SampleRow row = test_sample(i);
    row.time = i * SimTime{600'000'000};  // 10 min: 2.8 days
    // A circle of 60 m.
    row.place = {0.1 + 60 * std::cos(0.05 * i) / radius_m, 60 * std::sin(0.05 * i) / radius_m, 0};
    track.add(row);
    passed.push_back(row.place);
  }
  const std::vector<RoverTrack::Piece> driven = track.driven();
  ASSERT_EQ(driven.size(), 3u);
  EXPECT_EQ(driven[1].from, day_length);
  std::size_t points = 0;
  for (std::size_t k = 0; k < driven.size(); ++k) {
    points += driven[k].line.size();
    if (k == 0) continue;
    EXPECT_EQ(surface_distance_m(moon, driven[k - 1].line.back(), driven[k].line.front()), 0);
  }
  EXPECT_LT(points, 300u);
  // On the equator longitude and latitude are a plane.
  const auto plane_m = [&](const Geodetic& place) {
    return Vec2(radius_m * (place.lon_rad - 0.1), radius_m * place.lat_rad);
  };
  double farthest_m = 0;
  for (std::size_t i = 0; i < passed.size(); ++i) {
    double nearest_m = 1e9;
    const std::vector<Geodetic>& line = driven[i / 144].line;
    for (std::size_t k = 1; k < line.size(); ++k) {
      nearest_m = std::min(
          nearest_m, point_distance_m(plane_m(line[k - 1]), plane_m(line[k]), plane_m(passed[i])));
    }
    farthest_m = std::max(farthest_m, nearest_m);
  }
  EXPECT_LT(farthest_m, 1.001 * line_tolerance_m);
  EXPECT_GT(farthest_m, 0.1 * line_tolerance_m) << "points were left out";
}

}  // namespace
}  // namespace lsos
