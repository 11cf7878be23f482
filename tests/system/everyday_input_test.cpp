// Input of people and their tools other than a correct KML file.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>
#include <nlohmann/json.hpp>

#include "system/plan_run.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<Mark> pause(const Fields& fields, const std::string& start = "2026-07-01T00:00:00Z",
                        const std::string& terrain = "Flat") {
  Mark info{"MissionInfo", {{"Planet", "Moon"}, {"StartTime", start}, {"Terrain", terrain}}, ""};
  return {info, sev("A", "31.0,20.0"), event("Pause", "A", 10, fields)};
}

TEST(StartTime, is_read_as_mission_operations_write_it) {
  const TempFolder folder;
  for (const char* start : {"2026-246T06:00:00Z", "20260903T060000Z", "2026-09-03T06:00:00Z"}) {
    const std::string plan = folder.write("plan.kml", kml(pause({{"Duration", "5 s"}}, start)));
    ASSERT_EQ(run({plan, "-o", folder / "run", "--quiet", "--no-report"}).exit_code, 0) << start;
    EXPECT_EQ(query(folder / "run" / "log.gpkg", "select value from run where key = 'start_time'"),
              "2026-09-03T06:00:00.000Z");
  }
}

TEST(Duration, is_read_in_parts) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(pause({{"Duration", "1 min 30 s"}})));
  ASSERT_EQ(run({plan, "-o", folder / "run", "--quiet", "--no-report"}).exit_code, 0);
  EXPECT_EQ(summary(folder / "run")["events"][0]["end_s"], 90);
}

TEST(NoXml, is_told_what_it_is) {
  using namespace std::string_literals;
  const TempFolder folder;
  const std::vector<std::array<std::string, 3>> files{
      {"survey.plan", R"({"fileType": "Plan", "mission": {"items": []}})", "it is JSON"},
      {"list.json", "\n [1, 2]", "it is JSON"},
      {"waypoints.csv", "RoverId,Sequence\nR1,10\n", "it is a table of text, such as CSV"},
      {"semicolons.csv", "\xef\xbb\xbfRoverId;Sequence\n", "it is a table of text, such as CSV"},
      {"notes.txt", "drive to the crater", "it is text without a tag"},
      {"dem.tif", "II*\0\x08\0\0\0"s, "it is a TIFF raster"},
      {"plan.kml.gz", "\x1f\x8b\x08\0"s, "it is packed with gzip"},
      {"noise", "\x01\x02\x03\x04", "it is neither text nor a known format"}};
  for (const auto& [name, bytes, what] : files) {
    const std::string file = folder.write(name, bytes);
    const bool is_first = name == files.front()[0];
    for (const std::string& command : is_first ? Words{"check", "run", "fsm"} : Words{"check"}) {
      const Outcome outcome = run({command, file}, {.folder = folder.path()});
      EXPECT_EQ(outcome.exit_code, 2) << name;
      const std::string text = outcome.out + outcome.err;
      EXPECT_THAT(text, HasSubstr(name + ":1: is no XML: " + what));
      EXPECT_THAT(text, HasSubstr("; a KML or KMZ file is wanted"));
    }
  }
}

TEST(Pipe, is_read_as_a_plan) {
  const TempFolder folder;
  const std::string plan = folder.write("plan.kml", kml(pause({{"Duration", "5 s"}})));
  const Outcome outcome =
      run_command({"bash", "-c", "cat '" + plan + "' | '" LSOS_PROGRAM "' check /dev/stdin"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  const Outcome foreign =
      run_command({"bash", "-c", "echo a,b | '" LSOS_PROGRAM "' check /dev/stdin"});
  EXPECT_EQ(foreign.exit_code, 2);
  EXPECT_THAT(foreign.out, HasSubstr("/dev/stdin:1: is no XML: it is a table of text"));
}

// As bash makes of <(zcat rows.csv.gz).
TEST(Pipe, is_read_as_measured_rows) {
  const TempFolder folder;
  folder.write("plan.kml", kml(pause({{"Duration", "5 s"}})));
  const auto in_shell = [&](const std::string& line) {
    return run_command({"bash", "-c", "P='" LSOS_PROGRAM "'; " + line}, {.folder = folder.path()});
  };
  ASSERT_EQ(
      run({"run", "plan.kml", "-o", "run", "--no-report", "--quiet"}, {.folder = folder.path()})
          .exit_code,
      0);
  const Outcome rows = in_shell("$P compare run <(echo no,rows)");
  EXPECT_THAT(rows.err, HasSubstr("/dev/fd/")) << rows.out;
  EXPECT_THAT(rows.err, Not(HasSubstr("cannot be"))) << rows.out;
  EXPECT_THAT(rows.err, Not(HasSubstr("is a pipe"))) << rows.out;
}

// Writes a zip file with "ground.asc", 1.2 km by 1.2 km of level ground around the rover.
void write_zipped_ground(const fs::path& file) {
  std::string grid = "ncols 40\nnrows 40\nxllcorner 30.98\nyllcorner 19.98\ncellsize 0.001\n";
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) grid += "100 ";
    grid += "\n";
  }
  const std::string crs =
      "GEOGCS[\"Moon\",DATUM[\"D_Moon\",SPHEROID[\"Moon\",1737400,0]],PRIMEM[\"Reference\",0],"
      "UNIT[\"Degree\",0.0174532925199433]]";
  int error = 0;
  zip_t* archive = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
  ASSERT_NE(archive, nullptr);
  const std::pair<const char*, const std::string*> files[] = {{"ground.asc", &grid},
                                                              {"ground.prj", &crs}};
  for (const auto& [name, bytes] : files) {
    zip_source_t* source = zip_source_buffer(archive, bytes->data(), bytes->size(), 0);
    ASSERT_GE(zip_file_add(archive, name, source, 0), 0);
  }
  ASSERT_EQ(zip_close(archive), 0);
}

TEST(RasterInAnArchive, is_found_beside_the_plan_from_any_folder) {
  const TempFolder folder;
  const std::string plan = folder.write(
      "plans/plan.kml",
      kml(pause({{"Duration", "5 s"}}, "2026-07-01", "/vsizip/ground.zip/ground.asc")));
  write_zipped_ground(folder / "plans/ground.zip");
  for (const auto& [from, name] : {std::pair<fs::path, std::string>{folder / "plans", "plan.kml"},
                                   {folder.path(), "plans/plan.kml"},
                                   {"/", plan}}) {
    const Outcome outcome = run({"check", name}, {.folder = from});
    EXPECT_EQ(outcome.exit_code, 0) << from << outcome.out << outcome.err;
  }
}

}  // namespace
}  // namespace lsos::test
