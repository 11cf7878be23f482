#include "base/whole_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "base/error.h"
#include "base/files.h"
#include "base/output_error.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class WholeFileTest : public ::testing::TestWithParam<WholeFile::Kind> {
 protected:
  WholeFileTest() {
    std::string name = fs::temp_directory_path() / "whole_fileXXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~WholeFileTest() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ / name; }
  void replace(const std::string& name, const std::string& text) const {
    WholeFile file(path(name), GetParam());
    file.write(text);
    file.replace();
  }
  std::ptrdiff_t count() const { return std::distance(fs::directory_iterator(folder_), {}); }

  fs::path folder_;
};

INSTANTIATE_TEST_SUITE_P(With, WholeFileTest,
                         ::testing::Values(WholeFile::Kind::unnamed, WholeFile::Kind::named));

TEST_P(WholeFileTest, replaces_a_file_at_once) {
  replace("a.txt", "old");
  WholeFile file(path("a.txt"), GetParam());
  file.write("new ");
  file.write("text");
  EXPECT_EQ(read_file(path("a.txt")), "old");
  file.replace();
  EXPECT_EQ(read_file(path("a.txt")), "new text");
  EXPECT_EQ(count(), 1);
}

TEST_P(WholeFileTest, that_is_not_finished_leaves_nothing) {
  {
    WholeFile file(path("a.txt"), GetParam());
    file.write("half");
    EXPECT_EQ(count(), GetParam() == WholeFile::Kind::named ? 1 : 0);
  }
  EXPECT_EQ(count(), 0);
}

TEST_P(WholeFileTest, is_placed_only_where_the_name_is_free) {
  {
    WholeFile file(path("a.txt"), GetParam());
    file.write("first");
    file.place();
  }
  EXPECT_EQ(count(), 1);
  WholeFile file(path("a.txt"), GetParam());
  file.write("second");
  try {
    file.place();
    FAIL() << "the name is taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.txt: is there already; it is not replaced"));
  }
  EXPECT_EQ(read_file(path("a.txt")), "first");
}

// A received folder may hold links under the very names that the program would write to.
TEST_P(WholeFileTest, writes_through_no_link) {
  const fs::path victim = folder_ / "victim";
  write_file(victim, "theirs");
  for (const char* name : {"a.txt", "a.txt.lsos-host.part", "a.txt.2.lsos-host.part"}) {
    fs::create_symlink(victim, folder_ / name);
  }
  fs::create_symlink(folder_ / "not there", folder_ / "b.txt.lsos-host.part");
  fs::create_hard_link(victim, folder_ / "b.txt");
  replace("a.txt", "ours");
  replace("b.txt", "ours");
  EXPECT_EQ(read_file(victim), "theirs");
  EXPECT_EQ(read_file(path("a.txt")), "ours");
  EXPECT_FALSE(fs::is_symlink(path("a.txt")));
  EXPECT_EQ(read_file(path("b.txt")), "ours");
  EXPECT_FALSE(fs::exists(path("not there")));
  EXPECT_EQ(fs::read_symlink(path("a.txt.lsos-host.part")), victim) << "it is not ours";
  EXPECT_EQ(count(), 6) << "no further file";
}

TEST_P(WholeFileTest, leaves_a_strangers_part_alone) {
  write_file(path("a.txt.lsos-host.part"), "of another run");
  fs::create_directory(path("b.txt.lsos-host.part"));
  replace("a.txt", "ours");
  replace("b.txt", "ours");
  EXPECT_EQ(read_file(path("a.txt.lsos-host.part")), "of another run");
  EXPECT_EQ(read_file(path("b.txt")), "ours");
}

TEST_P(WholeFileTest, refuses_what_is_no_file) {
  fs::create_directory(path("folder"));
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0666), 0);
  fs::create_symlink("/dev/null", path("device"));
  const auto refusal = [&](const std::string& file) -> std::string {
    try {
      WholeFile whole(file, GetParam());
      return "not refused";
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(refusal(path("folder")), HasSubstr("folder: is a folder, and no file that could be"));
  EXPECT_THAT(refusal(path("pipe")), HasSubstr("pipe: is a named pipe, and no file"));
  EXPECT_THAT(refusal(path("device")), HasSubstr("device: is a device, and no file"));
  EXPECT_THAT(refusal("/dev/null"), HasSubstr("/dev/null: is a device"));
  EXPECT_THAT(refusal(path("folder/")), HasSubstr("folder/: Is a directory"));
  EXPECT_THAT(refusal(path("none/a.txt")), HasSubstr("none/a.txt: No such file or directory"));
  EXPECT_EQ(count(), 3);
}

// `--junit /dev/stdout > FILE`: /dev/stdout leads to FILE, and root may replace it.
TEST_P(WholeFileTest, replaces_no_link_of_the_machine) {
  const std::string file = path("a.txt");
  write_file(file, "theirs");
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  for (const char* folder : {"/proc/self/fd/", "/dev/fd/"}) {
    const std::string name = folder + std::to_string(descriptor);
    try {
      WholeFile whole(name, GetParam());
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(name + ": lies in a folder of the machine"));
    }
  }
  ::close(descriptor);
  EXPECT_EQ(read_file(file), "theirs");
}

TEST_P(WholeFileTest, has_a_name_as_long_as_there_are) {
  const std::string longest(255, 'x');
  replace(longest, "ours");
  replace(longest, "ours again");
  EXPECT_EQ(read_file(path(longest)), "ours again");
  EXPECT_THROW(replace(longest + "x", "ours"), InputError);
  EXPECT_EQ(count(), 1);
}

TEST_P(WholeFileTest, tells_a_full_disk_from_a_wrong_place) {
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{1000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  std::string why = "written";
  try {
    replace("a.txt", std::string(2000, 'x'));
  } catch (const OutputError& error) {
    why = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_DFL);
  EXPECT_THAT(why, HasSubstr("a.txt: File too large"));
  EXPECT_EQ(count(), 0);
}

}  // namespace
}  // namespace lsos
