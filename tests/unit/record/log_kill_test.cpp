// The log while it is written, after kill -9, and on a full disk.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>

#include "record/log.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

// Runs `work` in a child process, which exits with its result and never returns.
pid_t in_child(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  int code = 99;
  try {
    code = work();
  } catch (...) {
  }
  ::_exit(code);
}

int status_of(pid_t child) {
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return status;
}

TEST(LogKill, has_all_layers_before_the_first_row) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  const pid_t child = in_child([&] {
    const LogWriter log(file, moon_crs, test_start());
    return ::raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status_of(child)));

  const LogReader reader(file);
  EXPECT_TRUE(reader.samples().empty());
  EXPECT_EQ(reader.start(), test_start());
}

TEST(LogKill, keeps_what_was_committed) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  const pid_t child = in_child([&] {
    LogWriter log(file, moon_crs, test_start());
    for (int i = 0; i < 50'000; ++i) log.write(test_sample(i));
    log.write(test_event());
    log.commit();
    // More rows than SQLite's cache holds, so that uncommitted pages reach the disk as well.
    for (int i = 0; i < 50'000; ++i) log.write(test_sample(50'000 + i));
    return ::raise(SIGKILL);
  });
  ASSERT_TRUE(WIFSIGNALED(status_of(child)));

  const LogReader reader(file);
  EXPECT_EQ(reader.samples().size(), 50'000u);
  EXPECT_EQ(reader.events().size(), 1u);
  EXPECT_EQ(reader.last_sample_time(), test_sample(49'999).time);
}

TEST(LogKill, is_read_by_another_process_while_it_is_written) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  for (int i = 0; i < 10; ++i) log.write(test_sample(i));
  log.commit();
  log.write(test_sample(10));
  // A process that shares nothing with the writer, as a map viewer does.
  const std::string command =
      "ogrinfo -ro -al -so '" + file + "' samples > '" + file + ".txt' 2>&1";
  if (std::system("command -v ogrinfo > /dev/null") != 0) FAIL() << "no ogrinfo here";
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream answer(file + ".txt");
  const std::string text(std::istreambuf_iterator<char>(answer), {});
  EXPECT_THAT(text, ::testing::HasSubstr("Feature Count: 10\n"));
  EXPECT_THAT(text, ::testing::HasSubstr("Moon (2015)"));
  EXPECT_THAT(text, ::testing::HasSubstr("Extent: (-10.5"));
  log.finish();
}

TEST(LogKill, commits_at_least_once_a_second) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  LogWriter log(file, moon_crs, test_start());
  log.write(test_sample(0));
  log.commit_if_due();
  EXPECT_TRUE(LogReader(file).samples().empty());
  ::usleep(1'000'000);
  log.commit_if_due();
  EXPECT_EQ(LogReader(file).samples().size(), 1u);
}

TEST(LogKill, says_that_the_disk_is_full_and_keeps_the_last_commit) {
  const TestFolder folder;
  const std::string file = folder / "log.gpkg";
  const std::string message_file = folder / "message.txt";
  const pid_t child = in_child([&] {
    LogWriter log(file, moon_crs, test_start());
    for (int i = 0; i < 1000; ++i) log.write(test_sample(i));
    log.commit();
    // A limit on file size stands in for a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4'000'000, 4'000'000};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 2;
    try {
      for (int i = 0; i < 100'000; ++i) {
        log.write(test_sample(1000 + i));
        if (i % 5000 == 4999) log.write(test_event());
      }
      log.finish();
    } catch (const LogError& error) {
      std::ofstream(message_file) << error.what();
      return 3;
    }
    return 0;
  });
  const int status = status_of(child);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 3);

  std::ifstream answer(message_file);
  const std::string message(std::istreambuf_iterator<char>(answer), {});
  EXPECT_THAT(message, ::testing::ContainsRegex(
                           "log.gpkg: writing: (no space is left|.*a limit of file sizes)"));
  EXPECT_EQ(LogReader(file).samples().size(), 1000u);
}

}  // namespace
}  // namespace lsos
