// Logs that another program wrote or changed: what none of ours holds is an InputError that names
// the layer, the row and the column, before any product is made of it.
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <filesystem>
#include <fstream>

#include "base/error.h"
#include "record/log.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

// Runs statements as any program may.
void change(const std::string& file, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  char* error = nullptr;
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK)
      << sql << ": " << (error == nullptr ? "" : error);
  sqlite3_free(error);
  sqlite3_close(database);
}

// A finished log with a row or more in each layer that the cases below change.
void write_foreign_rows(const std::string& file) {
  LogWriter log(file, moon_crs, test_start());
  for (int i = 0; i < 3; ++i) log.write(test_sample(i));
  log.write(test_event());
  log.write(JointRow{SimTime{0}, "SEV1", "wheel 1", 0.25});
  PairRow pair;
  pair.from_id = "SEV1";
  pair.to_id = "Earth";
  log.write(pair);
  log.write(SightIntervalRow{"SEV1", "Earth", "visible", SimTime{0}, SimTime{1'000'000}});
  PlannedPathRow path;
  path.rover_id = "SEV1";
  path.line = {test_sample(0).place, test_sample(1).place};
  log.write(path);
  NoteRow note;
  note.rover_id = "SEV1";
  note.name = "stuck";
  note.fields_json = "{}";
  log.write(note);
  log.write_run({{"seed", "1"}});
  log.write(Checkpoint{SimTime{2'000'000}, CheckpointKind::kept, 1.5, "state"});
  log.finish();
}

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The same bytes for each test: writing them takes the most time.
std::string write_log(const TestFolder& folder) {
  static const std::string bytes = [&] {
    write_foreign_rows(folder / "first.gpkg");
    return bytes_of(folder / "first.gpkg");
  }();
  const std::string file = folder / "log.gpkg";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

// Reads all that products read.
void read_all(const std::string& file) {
  const LogReader log(file);
  log.start();
  log.last_sample_time();
  log.sample_totals();
  log.samples();
  log.joints();
  log.panels();
  log.pairs();
  log.sight_intervals();
  log.resources();
  log.events();
  log.phases();
  log.planned_paths();
  log.notes();
  log.orders();
  log.for_each_joint([](const JointRow&) {}, {SimTime{0}, SimTime{1}});
  log.branch();
  for (const CheckpointEntry& entry : log.checkpoints()) log.checkpoint(entry.id);
  log.sha256();
}

struct ForeignCase {
  const char* name;
  const char* sql;
  const char* message;
};

const ForeignCase cases[] = {
    {"text_for_number", "UPDATE samples SET speed_mps = 'fast' WHERE fid = 2",
     "layer 'samples', fid 2: speed_mps is 'fast': a number is allowed"},
    {"blob_for_number", "UPDATE samples SET slip = x'00ff' WHERE fid = 1",
     "layer 'samples', fid 1: slip is a blob: a number is allowed"},
    {"no_time", "UPDATE samples SET time_s = NULL WHERE fid = 3",
     "layer 'samples', fid 3: time_s is NULL: a number is needed"},
    {"infinite_time", "UPDATE samples SET time_s = 9e999 WHERE fid = 3",
     "layer 'samples', fid 3: time_s = inf: a number from 0 to 1000000000 is allowed"},
    {"negative_time", "UPDATE samples SET time_s = -1 WHERE fid = 1", "time_s = -1: a number from"},
    {"time_that_overflows", "UPDATE joints SET time_s = 1e300", "layer 'joints', fid 1: time_s"},
    {"time_that_is_text", "UPDATE joints SET time_s = 'noon'",
     "layer 'joints', fid 1: time_s is 'noon'"},
    {"times_backwards", "UPDATE samples SET time_s = 0 WHERE fid = 3",
     "layer 'samples', fid 3: time_s is less than in the row before"},
    {"infinite_number", "UPDATE samples SET energy_j = -9e999 WHERE fid = 1", "energy_j = -inf"},
    {"far_place", "UPDATE samples SET x_m = 1e12 WHERE fid = 1",
     "x_m = 1000000000000: a number from"},
    {"no_place_in_the_site", "UPDATE samples SET z_m = NULL", "fid 1: z_m is NULL"},
    {"latitude_over_the_pole", "UPDATE samples SET lat_deg = 91", "fid 1: lat_deg = 91"},
    {"no_rover", "UPDATE samples SET rover_id = NULL", "fid 1: rover_id is NULL: a text is needed"},
    {"rover_in_bytes", "UPDATE samples SET rover_id = CAST(x'ff41' AS TEXT)",
     "layer 'samples', fid 1: rover_id is no text in UTF-8"},
    {"zero_in_text", "UPDATE notes SET name = CAST(x'410042' AS TEXT)", "name is no text in UTF-8"},
    {"other_utc", "UPDATE samples SET utc = 'yesterday'", "fid 1: utc = 'yesterday': a time such"},
    {"unknown_status", "UPDATE events SET status = 'won'",
     "layer 'events', fid 1: status = 'won': allowed are not_started, waiting"},
    {"unknown_kind_of_sight", "UPDATE sight_intervals SET kind = 'seen'",
     "kind = 'seen': allowed are visible, hidden, link, relayed"},
    {"flag_of_two", "UPDATE pairs SET visible = 2",
     "layer 'pairs', fid 1: visible = 2: a number "
     "from 0 to 1"},
    {"sequence_in_text", "UPDATE events SET sequence = 'last'",
     "sequence is 'last': a whole number is allowed"},
    {"point_that_is_no_geometry", "UPDATE samples SET geom = x'4750000100000000'",
     "layer 'samples', fid 1: geom is no point"},
    {"point_in_a_line", "UPDATE planned_paths SET geom = (SELECT geom FROM samples LIMIT 1)",
     "layer 'planned_paths', fid 1: geom is no line"},
    {"text_for_geometry", "UPDATE samples SET geom = 'POINT (1 2)'", "geom is no point"},
    {"line_of_more_places_than_bytes",
     "UPDATE planned_paths SET geom = substr(geom, 1, length(geom) - 8)", "geom is no line"},
    // The point's longitude is infinite.
    {"place_that_is_none",
     "UPDATE samples SET geom = CAST(substr(geom, 1, length(geom) - 24) || x'000000000000f07f' || "
     "substr(geom, length(geom) - 15) AS BLOB) WHERE fid = 2",
     "layer 'samples', fid 2: geom lies at inf"},
    {"fid_of_zero", "UPDATE samples SET fid = -5 WHERE fid = 1",
     "layer 'samples': fid -5 does not follow 0"},
    {"no_layer", "DROP TABLE pairs", "it has no layer 'pairs'"},
    {"no_column", "ALTER TABLE samples RENAME COLUMN slip TO slipp", "has no column 'slip'"},
    {"layer_that_is_a_view",
     "ALTER TABLE samples RENAME TO rows; CREATE VIEW samples AS SELECT * FROM rows",
     "its layer 'samples' is no table but a view"},
    {"layer_that_is_virtual",
     "DROP TABLE resources; CREATE VIRTUAL TABLE resources USING fts5(fid, geom)",
     "its layer 'resources' is no table but a virtual table"},
    {"column_that_is_computed",
     "ALTER TABLE samples DROP COLUMN slip; ALTER TABLE samples ADD COLUMN slip AS (speed_mps)",
     "column 'slip' of layer 'samples' is computed"},
    {"rows_without_numbers",
     "DROP TABLE phases; CREATE TABLE phases (fid, rover_id, sequence, phase, start_s, end_s)",
     "the rows of layer 'phases' are not numbered by 'fid'"},
    {"other_application", "PRAGMA application_id = 1", "no GeoPackage (application_id is 1)"},
    {"start_that_is_no_number", "UPDATE run SET value = 'now' WHERE key = 'start_tai_us'",
     "layer 'run' has no 'start_tai_us'"},
    {"start_far_away", "UPDATE run SET value = '9223372036854775807' WHERE key = 'start_tai_us'",
     "layer 'run' has start_tai_us = 9223372036854775807: no time between"},
    {"checkpoint_of_no_time", "UPDATE lsos_checkpoints SET time_us = 'x'",
     "table 'lsos_checkpoints', id 1"},
    {"checkpoint_of_no_kind", "UPDATE lsos_checkpoints SET kind = 'first'",
     "table 'lsos_checkpoints', id 1"},
    {"checkpoint_of_other_bytes", "UPDATE lsos_checkpoints SET content = x'00'",
     "its checkpoint 1 is damaged"},
    {"checkpoint_in_text", "UPDATE lsos_checkpoints SET content = 5, sha256 = x'00'",
     "its checkpoint 1 is damaged"},
    {"branch_of_bytes",
     "CREATE TABLE lsos_branch (id, folder, log_sha256, time_us, changes); INSERT INTO lsos_branch "
     "VALUES (1, x'ff', '', 0, '')",
     "table 'lsos_branch', id 1: holds what lsos-host does not write"},
};

class ForeignLog : public ::testing::TestWithParam<ForeignCase> {};

TEST_P(ForeignLog, is_refused_with_its_row) {
  const TestFolder folder;
  const std::string file = write_log(folder);
  ASSERT_NO_THROW(read_all(file));
  change(file, GetParam().sql);
  try {
    read_all(file);
    FAIL() << "it was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
    EXPECT_THAT(error.what(), HasSubstr("log.gpkg: "));
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, ForeignLog, ::testing::ValuesIn(cases),
                         [](const auto& test) { return test.param.name; });

TEST(ForeignLogFile, may_be_damaged_anywhere) {
  const TestFolder folder;
  const std::string file = write_log(folder);
  const std::string bytes = bytes_of(file);
  // Each page is spoilt in turn, by bytes that differ.
  for (std::size_t at = 100; at < bytes.size(); at += 512) {
    std::string spoilt = bytes;
    for (std::size_t i = at; i < std::min(at + 16, bytes.size()); ++i) {
      spoilt[i] = static_cast<char>(spoilt[i] ^ static_cast<char>(37 * i + 1));
    }
    const std::string other = folder / "spoilt.gpkg";
    std::ofstream(other, std::ios::binary) << spoilt;
    try {
      read_all(other);
    } catch (const InputError&) {
      // What matters is that it is no other error.
    }
  }
}

TEST(ForeignLogFile, may_be_cut_off_anywhere) {
  const TestFolder folder;
  const std::string file = write_log(folder);
  const auto size = std::filesystem::file_size(file);
  for (const std::uintmax_t left : {size - 1, size / 2, size / 3, std::uintmax_t{100}}) {
    std::filesystem::resize_file(file, left);
    EXPECT_THROW(read_all(file), InputError) << left;
  }
}

TEST(ForeignLogFile, has_triggers_that_never_run) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  {
    LogWriter log(file, moon_crs, test_start());
    log.write(test_sample(0));
    log.write(Checkpoint{SimTime{0}, CheckpointKind::recent, 0, "state"});
  }
  change(file,
         "CREATE TRIGGER more AFTER INSERT ON samples BEGIN DELETE FROM events; END; CREATE TABLE "
         "seen (x)");
  change(file,
         "CREATE TRIGGER again AFTER DELETE ON samples BEGIN INSERT INTO seen VALUES (1); END");
  {
    LogWriter log(file, test_start(), LogReader(file).checkpoints().front().id);
    log.write(test_event());
    log.write(test_sample(1));
    log.finish();
  }
  EXPECT_EQ(LogReader(file).events().size(), 1u);
}

TEST(ForeignLogFile, gives_its_layers_no_functions) {
  const TestFolder folder;
  const std::string file = write_log(folder);
  // An index of an expression that would be read in place of the table.
  change(file, "CREATE INDEX wrong ON samples (speed_mps); REINDEX");
  change(file,
         "PRAGMA writable_schema = ON; UPDATE sqlite_master SET sql = 'CREATE INDEX wrong ON "
         "samples (slip)' WHERE name = 'wrong'");
  EXPECT_EQ(LogReader(file).samples().size(), 3u);
}

}  // namespace
}  // namespace lsos
