#include "access/bounded_files.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "access/refusal.h"
#include "support/test_folder.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;

class BoundedFiles : public ::testing::Test {
 protected:
  BoundedFiles() {
    bound_file_systems();
    forget_refusal();
  }

  std::string packed(const std::string& name) const {
    return "/vsizip/" + archive_.string() + "/" + name;
  }
  // Zeros, of which a thousand take a byte of the archive.
  void pack(const std::string& name, std::size_t mib) const {
    VSILFILE* file = VSIFOpenL(packed(name).c_str(), "wb");
    ASSERT_NE(file, nullptr);
    const std::vector<char> zeros(std::size_t{1} << 20);
    for (std::size_t i = 0; i < mib; ++i) {
      EXPECT_EQ(VSIFWriteL(zeros.data(), 1, zeros.size(), file), zeros.size());
    }
    VSIFCloseL(file);
  }
  bool opens(const std::string& name) const {
    VSILFILE* file = VSIFOpenL(packed(name).c_str(), "rb");
    if (file == nullptr) return false;
    EXPECT_EQ(VSIFTellL(file), 0u);
    VSIFCloseL(file);
    return true;
  }

  const TestFolder folder_;
  const fs::path archive_ = folder_ / "maps.zip";
};

TEST_F(BoundedFiles, of_an_archive_that_are_read_whole_are_bounded) {
  pack("dem.prj", 65);
  EXPECT_LT(fs::file_size(archive_), 1u << 20);
  EXPECT_FALSE(opens("dem.prj"));
  EXPECT_THAT(last_refusal(), ::testing::HasSubstr("dem.prj' is larger than 64 MiB; gdal_trans"));
}

TEST_F(BoundedFiles, of_an_archive_are_read_up_to_that_size) {
  pack("dem.prj", 63);
  EXPECT_TRUE(opens("dem.prj"));
}

TEST_F(BoundedFiles, of_an_archive_that_hold_samples_are_not) {
  pack("dem.asc", 65);
  EXPECT_TRUE(opens("dem.asc"));
}

}  // namespace
}  // namespace lsos
