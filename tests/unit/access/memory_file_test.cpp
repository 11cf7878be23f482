#include "access/memory_file.h"

#include <cpl_vsi.h>
#include <gtest/gtest.h>

namespace lsos {
namespace {

void write(const std::string& name, std::string_view bytes) {
  VSILFILE* file = VSIFOpenL(name.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), file), bytes.size());
  VSIFCloseL(file);
}

bool is_there(const std::string& name) {
  VSIStatBufL stat;
  return VSIStatL(name.c_str(), &stat) == 0;
}

TEST(MemoryFile, has_the_bytes_that_gdal_writes) {
  const MemoryFile file("map.tif");
  EXPECT_EQ(file.bytes(), "");
  EXPECT_TRUE(file.name().ends_with("/map.tif"));
  write(file.name(), "made");
  EXPECT_EQ(file.bytes(), "made");
}

TEST(MemoryFile, shares_its_folder_with_no_other) {
  const MemoryFile first("map.tif"), second("map.tif");
  write(first.name(), "first");
  EXPECT_EQ(second.bytes(), "");
}

TEST(MemoryFile, goes_with_what_lies_beside_it) {
  std::string name;
  {
    const MemoryFile file("map.tif");
    name = file.name();
    write(name, "made");
    write(name + ".aux.xml", "made as well");
  }
  EXPECT_FALSE(is_there(name));
  EXPECT_FALSE(is_there(name + ".aux.xml"));
}

}  // namespace
}  // namespace lsos
