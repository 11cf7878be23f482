// docs/log.md says what a log holds.
#include "record/log_reference.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "record/quantities.h"

namespace lsos {
namespace {

TEST(LogReference, is_the_page) {
  const std::string page = LSOS_SOURCE_DIR "/docs/log.md";
  if (std::getenv("LSOS_UPDATE_REFERENCE") != nullptr) std::ofstream(page) << log_reference();
  std::ostringstream file;
  file << std::ifstream(page).rdbuf();
  EXPECT_EQ(file.str(), log_reference())
      << "docs/log.md is out of date: LSOS_UPDATE_REFERENCE=1 with this test writes it anew";
}

TEST(Quantities, are_found_by_name) {
  ASSERT_NE(find_quantity("solar_w"), nullptr);
  EXPECT_EQ(find_quantity("solar_w")->part, QuantityPart::panels);
  EXPECT_EQ(find_quantity("solar"), nullptr);
}

TEST(Quantities, say_what_people_see) {
  for (const Quantity& quantity : quantities()) {
    EXPECT_FALSE(quantity.title.empty()) << quantity.name;
    EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
    EXPECT_LT(quantity.least, quantity.greatest) << quantity.name;
  }
}

}  // namespace
}  // namespace lsos
