// Checkpoints in a log, and logs that go on from one.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "record/log.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

Checkpoint checkpoint(int second, CheckpointKind kind = CheckpointKind::recent) {
  return {SimTime{1'000'000LL * second}, kind, 0.5 * second,
          std::string("state\0'of ", 10) + std::to_string(second)};
}

void write_rows(LogWriter& log, int from, int until) {
  for (int i = from; i < until; ++i) log.write(test_sample(i));
  EventRow event = test_event();
  event.distance_m = until;
  log.write(event);
}

std::vector<std::int64_t> seconds_of(const std::vector<CheckpointEntry>& entries) {
  std::vector<std::int64_t> times;
  for (const CheckpointEntry& entry : entries) times.push_back(entry.time.count() / 1'000'000);
  return times;
}

TEST(Checkpoint, is_read_as_it_was_written) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  write_rows(log, 0, 3);
  log.write(checkpoint(7));
  const LogReader reader(file);
  ASSERT_EQ(reader.checkpoints().size(), 1u);
  const StoredCheckpoint stored = reader.checkpoint(reader.checkpoints()[0].id);
  EXPECT_EQ(stored.time, SimTime{7'000'000});
  EXPECT_EQ(stored.wall_s, 3.5);
  EXPECT_EQ(stored.state, checkpoint(7).state);
  EXPECT_EQ(reader.samples().size(), 3u) << "the rows up to it are committed with it";
}

TEST(Checkpoint, may_have_a_large_state) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  const auto large = [](int second) {
    Checkpoint of = checkpoint(second);
    of.state.append(std::size_t{5'000'000} + second, static_cast<char>('a' + second));
    return of;
  };
  for (int second = 1; second <= 5; ++second) log.write(large(second));
  log.write(checkpoint(6));
  const LogReader reader(file);
  const std::vector<CheckpointEntry> entries = reader.checkpoints();
  ASSERT_THAT(seconds_of(entries), ::testing::ElementsAre(4, 5, 6));
  EXPECT_EQ(reader.checkpoint(entries[0].id).state, large(4).state);
  EXPECT_EQ(reader.checkpoint(entries[1].id).state, large(5).state);
  EXPECT_EQ(reader.checkpoint(entries[2].id).state, checkpoint(6).state);
  log.finish();
  EXPECT_LT(std::filesystem::file_size(file), 22'000'000u);
  EXPECT_THAT(LogReader(file).checkpoints(), ::testing::IsEmpty());
}

TEST(Checkpoint, may_have_events_that_a_branch_does_not_keep) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  EventRow event = test_event();
  for (const std::int64_t sequence : {10, 20, 30}) {
    event.sequence = sequence;
    log.write(event);
  }
  log.keep_events({{event.rover_id, 10}, {event.rover_id, 30}});
  event.sequence = 20;  // another one, at the end
  log.write(event);
  log.finish();
  std::vector<std::int64_t> left;
  for (const EventRow& row : LogReader(file).events()) left.push_back(row.sequence);
  EXPECT_EQ(left, (std::vector<std::int64_t>{10, 30, 20}));
}

TEST(Checkpoint, stays_as_long_as_its_kind_says) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  log.write(checkpoint(0, CheckpointKind::kept));
  for (int second = 1; second < 6; ++second) log.write(checkpoint(second));
  log.write(checkpoint(6, CheckpointKind::stop));
  EXPECT_EQ(seconds_of(LogReader(file).checkpoints()), (std::vector<std::int64_t>{0, 3, 4, 5, 6}));
  log.finish();
  EXPECT_EQ(seconds_of(LogReader(file).checkpoints()), std::vector<std::int64_t>{0});
}

TEST(Checkpoint, stays_in_the_log_of_a_run_that_can_go_on) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  log.write(checkpoint(6, CheckpointKind::stop));
  log.finish(true);
  EXPECT_EQ(seconds_of(LogReader(file).checkpoints()), std::vector<std::int64_t>{6});
}

// The log that goes on, and one in one piece.
TEST(Checkpoint, begins_where_a_log_goes_on) {
  const TestFolder folder;
  const std::string whole = folder / "whole.gpkg", parts = folder / "parts.gpkg";
  {
    LogWriter log(whole, moon_crs, test_start());
    write_rows(log, 0, 5);
    write_rows(log, 5, 9);
    log.finish();
  }
  {
    LogWriter log(parts, moon_crs, test_start());
    write_rows(log, 0, 5);
    log.write(checkpoint(5));
    write_rows(log, 5, 7);
    log.write(checkpoint(7));
    EventRow other = test_event();
    other.sequence = 20;
    log.write(other);
    log.commit();
  }
  const std::int64_t first = LogReader(parts).checkpoints()[0].id;
  {
    // Nothing is lost where it ends before its first commit.
    LogWriter log(parts, test_start(), first);
    write_rows(log, 5, 6);
  }
  EXPECT_EQ(LogReader(parts).samples().size(), 7u);
  LogWriter log(parts, test_start(), first);
  log.commit();
  EXPECT_EQ(LogReader(parts).samples().size(), 5u);
  EXPECT_EQ(LogReader(parts).events().size(), 1u);
  EXPECT_EQ(seconds_of(LogReader(parts).checkpoints()), std::vector<std::int64_t>{5});
  write_rows(log, 5, 9);
  log.finish();
  EXPECT_EQ(LogReader(parts).sha256(), LogReader(whole).sha256());
  EXPECT_EQ(LogReader(parts).events()[0].distance_m, 9);
}

TEST(Checkpoint, is_not_believed_when_a_byte_of_it_differs) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  {
    LogWriter log(file, moon_crs, test_start());
    log.write(checkpoint(5));
    log.finish(true);
  }
  const std::int64_t id = LogReader(file).checkpoints()[0].id;
  std::string bytes;
  {
    std::ifstream in(file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  const std::size_t at = bytes.find("'of 5");
  ASSERT_NE(at, std::string::npos);
  bytes[at + 4] = '6';
  std::ofstream(file, std::ios::binary) << bytes;
  try {
    LogReader(file).checkpoint(id);
    FAIL() << "it was believed";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("its checkpoint 1 is damaged"));
  }
  EXPECT_THROW(LogReader(file).checkpoint(id + 1), InputError);
}

TEST(Branch, says_where_it_left_another_run_and_drops_its_checkpoints) {
  const TestFolder folder;
  const std::string trunk = folder / "trunk.gpkg", branch = folder / "it's a branch.gpkg";
  {
    LogWriter log(trunk, moon_crs, test_start());
    write_rows(log, 0, 5);
    log.write(checkpoint(5, CheckpointKind::kept));
    log.finish();
  }
  EXPECT_FALSE(LogReader(trunk).branch());
  const LogReader reader(trunk);
  reader.copy_to(branch);
  EXPECT_EQ(LogReader(branch).sha256(), reader.sha256());
  LogWriter log(branch, test_start(), reader.checkpoints()[0].id);
  log.begin_branch({"it's/out", "abc", SimTime{9}, "with it's.lua"});
  const LogReader after(branch);
  EXPECT_TRUE(after.checkpoints().empty());
  ASSERT_TRUE(after.branch());
  EXPECT_EQ(after.branch()->folder, "it's/out");
  EXPECT_EQ(after.branch()->log_sha256, "abc");
  EXPECT_EQ(after.branch()->time, SimTime{9});
  EXPECT_EQ(after.branch()->changes, "with it's.lua");
  EXPECT_EQ(after.sha256(), reader.sha256());
}

}  // namespace
}  // namespace lsos
