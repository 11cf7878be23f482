// The choice of a log's notes that are shown.
#include "product/thinned_notes.h"

#include <gmock/gmock.h>

#include <map>

#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;
using ::testing::Le;

NoteRow note(int second, const std::string& name, const std::string& fields = "{}") {
  return {SimTime{second * 1'000'000LL}, "SEV1", 10, name, fields, test_sample(0).place};
}

// Writes a log with a note named `often` each second, and occasional rare ones.
std::string log_of(const TestFolder& folder, int seconds) {
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  for (int i = 0; i < seconds; ++i) {
    log.write(note(i, "often"));
    if (i % 100 == 50) log.write(note(i, "stuck"));
  }
  log.finish();
  return folder / "log.gpkg";
}

std::map<std::string, std::vector<double>> times_by_name(const ThinnedNotes& notes) {
  std::map<std::string, std::vector<double>> times;
  for (const NoteRow& row : notes.rows) times[row.name].push_back(seconds(row.time));
  return times;
}

TEST(ThinnedNotes, are_all_notes_where_there_are_few) {
  const TestFolder folder;
  const ThinnedNotes notes = thinned_notes(LogReader(log_of(folder, 300)));
  EXPECT_EQ(notes.in_log, 303u);
  EXPECT_EQ(notes.rows.size(), 303u);
}

TEST(ThinnedNotes, keep_rare_ones_and_spread_the_others_evenly) {
  const TestFolder folder;
  const ThinnedNotes notes = thinned_notes(LogReader(log_of(folder, 1000)), 60);
  EXPECT_EQ(notes.in_log, 1010u);
  auto times = times_by_name(notes);
  EXPECT_EQ(times["stuck"].size(), 10u);
  const std::vector<double>& often = times["often"];
  ASSERT_EQ(often.size(), 50u);
  EXPECT_EQ(often.front(), 0);
  EXPECT_EQ(often.back(), 999);
  for (std::size_t k = 1; k < often.size(); ++k) {
    EXPECT_NEAR(often[k] - often[k - 1], 999.0 / 49, 1) << k;
  }
}

TEST(ThinnedNotes, with_more_names_than_can_be_shown_are_bounded_too) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  for (int i = 0; i < 500; ++i) log.write(note(i, "name " + std::to_string(i)));
  log.finish();
  const ThinnedNotes notes = thinned_notes(LogReader(folder / "log.gpkg"), 20);
  EXPECT_EQ(notes.in_log, 500u);
  ASSERT_EQ(notes.rows.size(), 20u);
  EXPECT_EQ(notes.rows.front().name, "name 0");
  EXPECT_EQ(notes.rows.back().name, "name 499");
}

TEST(ThinnedNotes, leave_out_fields_that_are_very_long) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  log.write(note(0, "long", "{\"text\":\"" + std::string(100'000, 'x') + "\"}"));
  log.finish();
  const ThinnedNotes notes = thinned_notes(LogReader(folder / "log.gpkg"));
  ASSERT_EQ(notes.rows.size(), 1u);
  EXPECT_THAT(notes.rows[0].fields_json.size(), Le(shown_note_bytes_max));
  EXPECT_THAT(notes.rows[0].fields_json, HasSubstr("100011 bytes"));
}

TEST(LimitOfEach, fills_up_with_what_small_kinds_leave) {
  EXPECT_EQ(limit_of_each({}, 10), 10u);
  EXPECT_EQ(limit_of_each({3, 4}, 10), 10u);        // all fit
  EXPECT_EQ(limit_of_each({100, 2, 100}, 10), 4u);  // 2 + 4 + 4
  EXPECT_EQ(limit_of_each({9, 9, 9}, 2), 0u);
}

TEST(ThinnedNotes, have_the_beginning_of_a_long_name) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  log.write(note(0, "a" + std::string(100'000, 'b')));
  log.write(note(1, std::string(199, 'c') + "\u00e4\u00e4"));
  log.write(note(2, "short"));
  log.finish();
  const ThinnedNotes notes = thinned_notes(LogReader(folder / "log.gpkg"));
  ASSERT_EQ(notes.rows.size(), 3u);
  EXPECT_EQ(notes.rows[0].name, "a" + std::string(199, 'b') + "...");
  EXPECT_EQ(notes.rows[1].name, std::string(199, 'c') + "...");
  EXPECT_EQ(notes.rows[2].name, "short");
}

}  // namespace
}  // namespace lsos
