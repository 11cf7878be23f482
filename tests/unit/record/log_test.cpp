// The log as its readers find it: rows written and read back, one file, and the digest.
#include "record/log.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "base/error.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

TEST(Log, gives_back_the_samples_that_were_written) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  for (int i = 0; i < 3; ++i) log.write(test_sample(i));
  log.finish();

  const std::vector<SampleRow> rows = LogReader(folder / "log.gpkg").samples();

  ASSERT_EQ(rows.size(), 3u);
  const SampleRow expected = test_sample(2);
  EXPECT_EQ(rows[2].time, expected.time);
  EXPECT_EQ(rows[2].rover_id, "SEV1");
  EXPECT_NEAR(lon_deg(rows[2].place), -10.4998, 1e-12);
  EXPECT_NEAR(lat_deg(rows[2].place), -89.25, 1e-12);
  EXPECT_EQ(rows[2].place.height_m, 12.5);
  EXPECT_EQ(rows[2].elevation_m, expected.elevation_m);
  EXPECT_EQ(rows[2].p_S_m, expected.p_S_m);
  EXPECT_EQ(rows[2].distance_m, expected.distance_m);
  EXPECT_EQ(rows[2].slip, 0.05);
  EXPECT_TRUE(std::isnan(rows[2].energy_j));
  EXPECT_EQ(rows[2].event, "Route 1");
  EXPECT_EQ(rows[2].phase, "drive");
}

TEST(Log, gives_back_joints_phases_and_notes) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  log.write(JointRow{SimTime{100'000}, "SEV1", "wheel 1", 0.25});
  log.write(JointRow{SimTime{200'000}, "SEV1", "wheel 1", 0.5});
  log.write(PhaseRow{"SEV1", 3, "drive", SimTime{200'000}, SimTime{300'000}});
  log.write(PhaseRow{"SEV1", 4, "wait", SimTime{300'000}, {}});
  log.write(NoteRow{SimTime{400'000}, "SEV1", 3, "reached", R"({"waypoint":2})",
                    geodetic_from_degrees(20, 30, 40)});
  log.finish();

  const LogReader reader(folder / "log.gpkg");
  const std::vector<JointRow> joints = reader.joints();
  ASSERT_EQ(joints.size(), 2u);
  EXPECT_EQ(joints[0].joint, "wheel 1");
  EXPECT_EQ(joints[0].angle_rad, 0.25);
  EXPECT_TRUE(std::isnan(joints[0].extension_m));
  std::vector<double> angles_rad;
  const auto visit = [&](const JointRow& row) { angles_rad.push_back(row.angle_rad); };
  reader.for_each_joint(visit, {SimTime{100'000}, SimTime{199'999}});
  reader.for_each_joint(visit, {SimTime{200'000}, SimTime{200'000}});
  EXPECT_EQ(angles_rad, (std::vector{0.25, 0.5}));
  EXPECT_EQ(reader.joints().size(), 2u);
  const std::vector<PhaseRow> phases = reader.phases();
  ASSERT_EQ(phases.size(), 2u);
  EXPECT_EQ(phases[0].end, SimTime{300'000});
  EXPECT_EQ(phases[1].end, std::nullopt);
  const std::vector<NoteRow> notes = reader.notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].fields_json, R"({"waypoint":2})");
  EXPECT_NEAR(lat_deg(notes[0].place), 30, 1e-12);
}

TEST(Log, gives_back_planned_paths_with_their_lines) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  PlannedPathRow row;
  row.time = SimTime{700'000};
  row.rover_id = "SEV1";
  row.sequence = 4;
  row.leg = 2;
  row.attempt = 1;
  row.length_m = 123.5;
  row.slope_max_rad = 0.2;
  row.steepest = geodetic_from_degrees(-18.5, 80.75);
  row.line = {geodetic_from_degrees(-20, 80, 5), geodetic_from_degrees(-19, 81, -6),
              geodetic_from_degrees(-18, 80.5, 7)};
  log.write(row);
  log.finish();
  const std::vector<PlannedPathRow> rows = LogReader(folder / "log.gpkg").planned_paths();
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].time, row.time);
  EXPECT_EQ(rows[0].leg, 2);
  EXPECT_EQ(rows[0].attempt, 1);
  EXPECT_EQ(rows[0].length_m, 123.5);
  EXPECT_NEAR(lon_deg(rows[0].steepest), -18.5, 1e-12);
  EXPECT_NEAR(lat_deg(rows[0].steepest), 80.75, 1e-12);
  ASSERT_EQ(rows[0].line.size(), 3u);
  EXPECT_NEAR(lat_deg(rows[0].line[1]), 81, 1e-12);
  EXPECT_NEAR(rows[0].line[1].height_m, -6, 1e-9);
}

TEST(Log, updates_an_event_in_its_row) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  EventRow event = test_event();
  log.write(event);
  EventRow other = test_event();
  other.sequence = 20;
  log.write(other);
  log.commit();
  event.status = EventStatus::failed;
  event.reason = "stuck";
  event.end = SimTime{5'000'000};
  event.place = geodetic_from_degrees(1, 2, 3);
  log.write(event);
  log.finish();

  const std::vector<EventRow> rows = LogReader(folder / "log.gpkg").events();

  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].sequence, 10);
  EXPECT_EQ(rows[0].status, EventStatus::failed);
  EXPECT_EQ(rows[0].reason, "stuck");
  EXPECT_EQ(rows[0].start, SimTime{100'000});
  EXPECT_EQ(rows[0].end, SimTime{5'000'000});
  ASSERT_TRUE(rows[0].place);
  EXPECT_NEAR(lon_deg(*rows[0].place), 1, 1e-12);
  EXPECT_EQ(rows[1].status, EventStatus::running);
  EXPECT_EQ(rows[1].end, std::nullopt);
  EXPECT_FALSE(rows[1].place);
}

TEST(Log, knows_its_start_and_what_it_was_made_of) {
  const TestFolder folder;
  const Instant start = test_start() + SimTime{123'457};
  LogWriter log(folder / "log.gpkg", moon_crs, start);
  log.write_run({{"seed", "7"}, {"renderer", "none"}});
  log.write_run({{"renderer", "llvmpipe"}});
  log.write(test_sample(21));
  log.finish();

  const LogReader reader(folder / "log.gpkg");
  EXPECT_EQ(reader.start(), start);
  EXPECT_EQ(reader.run().at("seed"), "7");
  EXPECT_EQ(reader.run().at("renderer"), "llvmpipe");
  EXPECT_EQ(reader.run().size(), 3u);
  EXPECT_EQ(reader.last_sample_time(), SimTime{42'000'000});
}

TEST(Log, is_one_file_when_finished) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  log.write(test_sample(0));
  log.finish();

  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
  }
  EXPECT_EQ(files, 1);
  // Bytes 18 and 19 of an SQLite file are 1 for a journal that is deleted, 2 for WAL.
  std::ifstream bytes(folder / "log.gpkg", std::ios::binary);
  char header[20] = {};
  bytes.read(header, sizeof header);
  EXPECT_EQ(header[18], 1);
  EXPECT_EQ(header[19], 1);
}

TEST(Log, is_whole_when_it_finishes_before_the_eyes_of_a_reader) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  log.write(test_sample(0));
  log.commit();
  {
    const LogReader reader(folder / "log.gpkg");
    EXPECT_EQ(reader.samples().size(), 1u);
    log.write(test_sample(1));
    log.finish();
    EXPECT_EQ(reader.samples().size(), 2u);
  }
  // The content of the log file without its journal.
  std::filesystem::copy_file(folder / "log.gpkg", folder / "copy.gpkg");
  EXPECT_EQ(LogReader(folder / "copy.gpkg").samples().size(), 2u);
  EXPECT_FALSE(std::filesystem::exists(folder / "log.gpkg-wal"));
}

TEST(Log, is_left_as_the_last_commit_when_not_finished) {
  const TestFolder folder;
  {
    LogWriter log(folder / "log.gpkg", moon_crs, test_start());
    log.write(test_sample(0));
    log.commit();
    log.write(test_sample(1));
  }
  EXPECT_EQ(LogReader(folder / "log.gpkg").samples().size(), 1u);
}

TEST(Log, refuses_to_write_over_a_file) {
  const TestFolder folder;
  LogWriter(folder / "log.gpkg", moon_crs, test_start()).finish();
  EXPECT_THROW(LogWriter(folder / "log.gpkg", moon_crs, test_start()), LogError);
  EXPECT_NO_THROW(LogReader(folder / "log.gpkg"));
}

TEST(Log, refuses_an_unknown_reference_system) {
  const TestFolder folder;
  EXPECT_THROW(LogWriter(folder / "log.gpkg", "IAU_2015:1", test_start()), LogError);
}

TEST(Log, is_read_only_from_a_log_of_ours) {
  const TestFolder folder;
  try {
    const LogReader reader(folder / "none.gpkg");
    FAIL() << "a file that does not exist was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("none.gpkg: no such file: no run has written it"));
  }
}

struct DigestCase {
  const char* what;
  void (*write)(LogWriter& log);
};

std::string digest_of(const TestFolder& folder, const std::string& name,
                      void (*write)(LogWriter& log)) {
  const std::string file = folder / name;
  LogWriter log(file, moon_crs, test_start());
  write(log);
  log.finish();
  return LogReader(file).sha256();
}

void write_some(LogWriter& log) {
  log.write(test_sample(0));
  log.write(test_sample(1));
  log.write(test_event());
}

TEST(LogDigest, is_equal_for_equal_rows) {
  const TestFolder folder;
  const std::string once = digest_of(folder, "a.gpkg", write_some);
  // The digest depends neither on when commits fell nor on an event having been written twice.
  const std::string again = digest_of(folder, "b.gpkg", [](LogWriter& log) {
    EventRow event = test_event();
    event.status = EventStatus::waiting;
    log.write(test_sample(0));
    log.write(event);
    log.commit();
    log.write(test_sample(1));
    log.write(test_event());
  });
  EXPECT_EQ(once, again);
  EXPECT_EQ(once.size(), 64u);
}

TEST(LogDigest, differs_when_anything_does) {
  const TestFolder folder;
  const std::string reference = digest_of(folder, "reference.gpkg", write_some);
  const DigestCase cases[] = {
      {"last bit of a number",
       [](LogWriter& log) {
         SampleRow row = test_sample(0);
         row.speed_mps = std::nextafter(row.speed_mps, 1);
         log.write(row);
         log.write(test_sample(1));
         log.write(test_event());
       }},
      {"NULL for zero",
       [](LogWriter& log) {
         SampleRow row = test_sample(0);
         row.distance_m = not_modelled;
         log.write(row);
         log.write(test_sample(1));
         log.write(test_event());
       }},
      {"order of rows",
       [](LogWriter& log) {
         log.write(test_sample(1));
         log.write(test_sample(0));
         log.write(test_event());
       }},
      {"a geometry",
       [](LogWriter& log) {
         write_some(log);
         EventRow event = test_event();
         event.place = geodetic_from_degrees(0, 0);
         log.write(event);
       }},
      {"a further row",
       [](LogWriter& log) {
         write_some(log);
         log.write(JointRow{SimTime{0}, "SEV1", "wheel 1", 0.25});
       }},
      {"a row of run",
       [](LogWriter& log) {
         write_some(log);
         log.write_run({{"seed", "1"}});
       }},
  };
  int i = 0;
  for (const DigestCase& one : cases) {
    const std::string digest = digest_of(folder, std::to_string(i++) + ".gpkg", one.write);
    EXPECT_NE(digest, reference) << one.what;
  }
}

TEST(Log, ends_at_its_greatest_size_and_stays_readable) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  log.limit_size(1'000'000);
  std::size_t written = 0;
  const auto write_on = [&] {
    for (; written < 100'000; ++written) {
      log.write(NoteRow{SimTime{}, "SEV1", 3, "note", std::string(100, 'x'), {}});
      if (written % 1000 == 999) log.commit();
    }
  };
  try {
    write_on();
    FAIL() << "no end";
  } catch (const LogError& error) {
    EXPECT_THAT(error.what(), HasSubstr("log.gpkg: takes 0.00"));
    EXPECT_THAT(error.what(), HasSubstr("where 0.001 GB are allowed; --log-max allows more"));
  }
  EXPECT_GT(written, 1000u);
  EXPECT_EQ(LogReader(folder / "log.gpkg").row_count("notes"), written + 1);
}

TEST(Log, is_read_in_pieces_that_fit_into_memory) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  const std::string fields = "{\"text\":\"" + std::string(std::size_t{1} << 20, 'x') + "\"}";
  for (int k = 0; k < 40; ++k) {
    log.write(NoteRow{SimTime{}, "SEV1", k, "note", fields, {}});
  }
  log.finish();
  const LogReader reader(folder / "log.gpkg");
  std::int64_t fid = 0;
  std::size_t rows = 0, pieces = 0;
  for (;; ++pieces) {
    const std::vector<LogRow> piece = reader.rows_after("notes", fid, 4096);
    if (piece.empty()) break;
    EXPECT_LE(piece.size(), 17u);
    rows += piece.size();
    fid = piece.back().fid;
  }
  EXPECT_EQ(rows, 40u);
  EXPECT_EQ(pieces, 3u);
}

}  // namespace
}  // namespace lsos
