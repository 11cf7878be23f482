// What is written can be read back: texts that are none and numbers beyond a column's limits do not
// make a log that its own reader refuses.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "record/log.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(StoredValue, texts_that_are_no_text_are_read_back) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  EventRow event = test_event();
  event.reason = "x\xc3";
  log.write(event);
  log.write(PhaseRow{"SEV1", 3, "pa\xffuse", SimTime{0}, {}});
  log.write(NoteRow{SimTime{0}, "SEV1", 3, std::string("na\0me", 5), "{}", {}});
  log.write_run({{"plan", "M\xe4rz.kml"}});
  log.write(Checkpoint{SimTime{0}, CheckpointKind::kept, 1.5, "state"});
  log.begin_branch({"M\xe4rz", "abc", SimTime{0}, "\xff"});
  log.finish();

  const LogReader reader(folder / "log.gpkg");
  EXPECT_NO_THROW(reader.sha256());
  EXPECT_EQ(reader.events().at(0).reason, "x\ufffd");
  EXPECT_EQ(reader.phases().at(0).phase, "pa\ufffduse");
  EXPECT_EQ(reader.notes().at(0).name, "na\ufffdme");
  EXPECT_EQ(reader.branch().value().folder, "M\ufffdrz");
}

TEST(StoredValue, numbers_beyond_the_limits_are_left_out_and_counted) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  SampleRow sample = test_sample(0);
  log.write(sample);
  EXPECT_EQ(log.lost_numbers(), "");
  sample.load_j = infinite;
  log.write(sample);
  log.write(ResourceRow{SimTime{0}, "SEV1", "data", 1e21});
  EXPECT_THAT(log.lost_numbers(), HasSubstr("layer 'samples': load_j = inf: too large"));
  EXPECT_THAT(log.lost_numbers(), HasSubstr("2 numbers in all"));
  log.finish();

  const LogReader reader(folder / "log.gpkg");
  EXPECT_NO_THROW(reader.sha256());
  EXPECT_TRUE(std::isnan(reader.samples().at(1).load_j));
  EXPECT_TRUE(std::isnan(reader.resources().at(0).amount));
}

TEST(StoredValue, a_number_that_a_row_cannot_lack_ends_the_writing) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  SampleRow sample = test_sample(0);
  sample.p_S_m.x() = infinite;
  try {
    log.write(sample);
    FAIL() << "is written";
  } catch (const LogError& error) {
    EXPECT_THAT(error.what(), HasSubstr("layer 'samples': x_m = inf: a number from -1e+09 to"));
  }
}

TEST(StoredValue, a_place_that_is_none_is_left_out) {
  const TestFolder folder;
  LogWriter log(folder / "log.gpkg", moon_crs, test_start());
  SampleRow sample = test_sample(0);
  sample.place.height_m = infinite;
  log.write(sample);
  log.finish();
  EXPECT_EQ(LogReader(folder / "log.gpkg").samples().size(), 1u);
}

}  // namespace
}  // namespace lsos
