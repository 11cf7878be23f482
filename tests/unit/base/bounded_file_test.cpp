#include "base/bounded_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "base/error.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class BoundedFile : public ::testing::Test {
 protected:
  BoundedFile() { fs::create_directories(folder_); }
  ~BoundedFile() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string written(const std::string& name, const std::string& bytes) const {
    std::ofstream(file(name), std::ios::binary) << bytes;
    return file(name);
  }

  fs::path folder_ = fs::path(::testing::TempDir()) /
                     ("bounded_file_" + std::to_string(getpid()) + "_" +
                      ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(BoundedFile, reads_all_bytes_of_a_regular_file) {
  const std::string bytes = std::string(3 << 20, 'x') + '\0' + "end";
  EXPECT_EQ(read_bounded(written("a", bytes)).value, bytes);
  EXPECT_EQ(read_bounded(written("empty", "")).value, "");
}

TEST_F(BoundedFile, says_what_stands_there_instead) {
  EXPECT_EQ(read_bounded(folder_.string()).why, "is a folder");
  EXPECT_EQ(read_bounded("/dev/zero").why, "is a device or a terminal");
  EXPECT_THAT(read_bounded(file("absent")).why, HasSubstr("No such file"));
  fs::create_symlink("self", file("self"));
  EXPECT_THAT(read_bounded(file("self")).why, HasSubstr("symbolic links"));
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  EXPECT_EQ(read_bounded(file("pipe")).why, "is a pipe");
  EXPECT_EQ(other_than_file(file("pipe")), "is a pipe");
  EXPECT_EQ(other_than_file(file("absent")), "");
  EXPECT_EQ(other_than_file(written("a", "x")), "");
}

TEST_F(BoundedFile, refuses_more_than_its_bound_without_reading_it) {
  const std::string sparse = written("sparse", "x");
  fs::resize_file(sparse, std::uintmax_t{100} << 30);
  EXPECT_EQ(read_bounded(sparse).why, "is larger than 256 MiB");
  FileBounds few;
  few.bytes_max = 10;
  EXPECT_EQ(read_bounded(written("ten", "0123456789"), few).value, "0123456789");
  EXPECT_EQ(read_bounded(written("eleven", "0123456789a"), few).why, "is larger than 10 bytes");
}

TEST_F(BoundedFile, reads_a_pipe_where_one_is_allowed_and_waits_for_who_writes) {
  const std::string pipe = file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  FileBounds bounds;
  bounds.may_be_pipe = true;
  std::thread writer([&] { std::ofstream(pipe) << "late"; });
  EXPECT_EQ(read_bounded(pipe, bounds).value, "late");
  writer.join();
  bounds.silence_max = std::chrono::milliseconds(50);
  EXPECT_THAT(read_bounded(pipe, bounds).why, StartsWith("is a pipe into which nothing was"));
}

TEST_F(BoundedFile, that_the_user_names_may_be_a_pipe) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(pipe(ends), 0);
  ASSERT_EQ(write(ends[1], "rows", 4), 4);
  close(ends[1]);
  EXPECT_EQ(read_named_file("/dev/fd/" + std::to_string(ends[0])), "rows");
  close(ends[0]);
  try {
    read_named_file(folder_.string());
    ADD_FAILURE() << "a folder was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(": is a folder"));
  }
}

}  // namespace
}  // namespace lsos
