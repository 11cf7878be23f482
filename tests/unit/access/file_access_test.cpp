#include "access/file_access.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/test_folder.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;

class FileAccess : public ::testing::Test {
 protected:
  FileAccess() {
    fs::create_directories(root_ / "plans/maps");
    fs::create_directories(root_ / "private");
    restrict_access(false);
  }

  std::string at(const std::string& name) const { return (root_ / name).string(); }

  const TestFolder folder_;
  const fs::path root_ = folder_.path();
};

TEST_F(FileAccess, reaches_what_lies_below_an_allowed_folder) {
  EXPECT_FALSE(is_allowed(at("plans/dem.tif")));
  allow_folder(at("plans"));
  EXPECT_TRUE(is_allowed(at("plans/dem.tif")));
  EXPECT_TRUE(is_allowed(at("plans/maps/dem.tif")));
  EXPECT_TRUE(is_allowed(at("private/../plans/dem.tif")));
  EXPECT_FALSE(is_allowed(at("plans/../private/dem.tif")));
  EXPECT_FALSE(is_allowed(at("plans_of_others/dem.tif")));
  EXPECT_FALSE(is_allowed("/etc/passwd"));
}

TEST_F(FileAccess, follows_links_of_files_and_folders) {
  std::ofstream(at("private/key")) << "secret";
  fs::create_symlink(at("private/key"), at("plans/dem.tif"));
  fs::create_directory_symlink(at("private"), at("plans/linked"));
  fs::create_directory_symlink(at("plans"), at("shortcut"));
  allow_folder(at("shortcut"));
  EXPECT_TRUE(is_allowed(at("plans/other.tif")));
  EXPECT_FALSE(is_allowed(at("plans/dem.tif")));
  EXPECT_FALSE(is_allowed(at("plans/linked/key")));
  EXPECT_FALSE(is_allowed(at("plans/linked/not_there")));
}

TEST_F(FileAccess, reaches_the_files_that_belong_to_a_named_one) {
  allow_file(at("private/dem.tif"));
  EXPECT_TRUE(is_allowed(at("private/dem.tif")));
  EXPECT_TRUE(is_allowed(at("private/dem.tif.aux.xml")));
  EXPECT_TRUE(is_allowed(at("private/dem.prj")));
  EXPECT_FALSE(is_allowed(at("private/demo.tif")));
  EXPECT_FALSE(is_allowed(at("private")));
}

TEST_F(FileAccess, tells_what_would_allow_a_file) {
  EXPECT_THAT(refused_file(at("private/dem.tif")),
              ::testing::HasSubstr("--allow-files '" + at("private") + "'"));
}

}  // namespace
}  // namespace lsos
