#include "study/filled_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace lsos {
namespace {

using ::testing::HasSubstr;

const TemplateValues values{
    {"name", {"study"}}, {"tasks", {"1-2", "3"}}, {"time", {}}, {"odd", {"{{name}} it's"}}};

std::string fault(const std::string& text) {
  try {
    filled_template(text, values, "slurm.sh");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FilledTemplate, has_a_line_for_each_value) {
  EXPECT_EQ(
      filled_template("a {{name}} b\n--time={{time}}\n{{name}}: {{tasks}}\nend\n", values, ""),
      "a study b\nstudy: 1-2\nstudy: 3\nend\n");
}

TEST(FilledTemplate, leaves_a_line_out_where_one_of_its_values_is_absent) {
  EXPECT_EQ(filled_template("{{tasks}} {{time}}\n{{time}} {{tasks}}\n", values, ""), "");
}

TEST(FilledTemplate, reads_no_value_again) {
  EXPECT_EQ(filled_template("{{odd}}\n", values, ""), "{{name}} it's\n");
}

TEST(FilledTemplate, keeps_other_braces) {
  const std::string text = "${name} {} {{ not closed\n}}\n";
  EXPECT_EQ(filled_template(text, values, ""), text);
}

TEST(FilledTemplate, names_the_line_of_what_it_does_not_know) {
  EXPECT_THAT(fault("\n{{nam}}\n"),
              HasSubstr("slurm.sh:2: {{nam}}: there is no such value; did you mean 'name'?"));
  EXPECT_THAT(fault("{{tasks}} {{tasks}}\n"), HasSubstr("slurm.sh:1: a line has one value"));
}

}  // namespace
}  // namespace lsos
