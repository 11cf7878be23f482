#include "study/shell_word.h"

#include <gtest/gtest.h>

#include "base/child_process.h"

namespace lsos {
namespace {

TEST(ShellWord, leaves_plain_names_as_they_are) {
  EXPECT_EQ(shell_word("/home/me/my_study-1.lua"), "/home/me/my_study-1.lua");
  EXPECT_EQ(shell_word(""), "''");
  EXPECT_EQ(shell_command({"sweep", "run", "my study"}), "sweep run 'my study'");
}

// The shell itself says what it reads.
TEST(ShellWord, is_read_by_a_shell_as_what_it_was) {
  for (const std::string text : {"it's", "a b", "$HOME", "`date`", "x; exit 3", "#no", "~", "a\\b",
                                 "*", "\"", "é", "a=b", "''", "!", "{a,b}", "-n"}) {
    const ProgramOutput said = program_output({"sh", "-c", "printf '<%s>' " + shell_word(text)});
    EXPECT_EQ(said.text, "<" + text + ">");
  }
}

}  // namespace
}  // namespace lsos
