#include "base/output_file.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

#include "base/error.h"
#include "base/files.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class OutputFile : public ::testing::Test {
 protected:
  OutputFile() {
    std::string name = fs::temp_directory_path() / "output_fileXXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~OutputFile() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return folder_ / name; }

  fs::path folder_;
};

std::string refusal_of_links(const std::string& folder, const std::string& name) {
  try {
    refuse_links(folder, name);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST_F(OutputFile, is_free_only_where_not_even_a_link_lies) {
  write_file(path("taken.kml"), "theirs");
  fs::create_symlink(path("nowhere"), path("link.kml"));
  Faults faults;
  check_free("-o", path("free.kml"), "--force replaces it", faults);
  check_free("-o", "", "--force replaces it", faults);
  EXPECT_FALSE(faults.has_errors());
  check_free("-o", path("taken.kml"), "--force replaces it", faults);
  check_free("-o", path("link.kml"), "it is not replaced", faults);
  std::string told;
  for (const Fault& fault : faults.sorted()) told += to_string(fault) + "\n";
  EXPECT_THAT(told, HasSubstr("link.kml: is there already; it is not replaced"));
  EXPECT_THAT(told, HasSubstr("taken.kml: is there already; --force replaces it"));
}

TEST_F(OutputFile, goes_through_no_link_that_the_user_has_not_named) {
  fs::create_directories(path("there/b"));
  fs::create_directory_symlink(path("there"), path("link"));
  fs::create_directory_symlink(path("there"), path("there/b/c"));
  EXPECT_EQ(refusal_of_links(path("there"), "b"), "");
  EXPECT_EQ(refusal_of_links(path("there"), "new/folders"), "");
  EXPECT_EQ(refusal_of_links(path("link"), "b"), "") << "the user has named it";
  EXPECT_THAT(
      refusal_of_links(folder_, "link/b"),
      HasSubstr("link: is a link, to " + path("there") + ": nothing is written through it"));
  EXPECT_THAT(refusal_of_links(path("there"), "b/c/d"), HasSubstr("b/c: is a link, to "));
}

}  // namespace
}  // namespace lsos
