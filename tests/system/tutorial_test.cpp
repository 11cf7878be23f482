// Follows the tutorials of events/README.md and rovers/README.md in an empty folder.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <regex>

#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// The text between `begin` and `end`, searched from `at` on; moves `at` behind `end`.
std::string between(const std::string& text, std::size_t& at, const std::string& begin,
                    const std::string& end) {
  const std::size_t from = text.find(begin, at) + begin.size(), to = text.find(end, from);
  at = to + end.size();
  return text.substr(from, to - from);
}

class Reader {
 public:
  Reader() {
    // The tutorial calls the program by its name.
    fs::create_directories(folder_ / "bin");
    fs::create_symlink(program({}).front(), folder_ / "bin/lsos-host");
    fs::create_directories(folder_ / "work");
  }

  Outcome run_line(const std::string& command) const {
    const std::string path = (folder_ / "bin").string() + ":" + std::getenv("PATH");
    return run_command({"bash", "-o", "pipefail", "-c", command},
                       {folder_ / "work", {"PATH=" + path}});
  }
  // Writes each Lua block to the file named last before it, and runs each command.
  void follow(const std::string& text) const {
    static const std::regex block("```(lua|console)\n([^`]*(?:`[^`]+)*?)```");
    static const std::regex named("`((?:events|rovers|tests/scenarios)/[A-Za-z0-9]+\\.lua)`");
    std::string file;
    std::size_t done = 0;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), block);
         at != std::sregex_iterator(); ++at) {
      const auto begin = static_cast<std::size_t>(at->position());
      const std::string prose = text.substr(done, begin - done);
      for (auto name = std::sregex_iterator(prose.begin(), prose.end(), named);
           name != std::sregex_iterator(); ++name) {
        file = (*name)[1];
      }
      done = begin + static_cast<std::size_t>(at->length());
      if ((*at)[1] == "lua") {
        write(file, (*at)[2]);
        continue;
      }
      std::istringstream lines((*at)[2]);
      for (std::string line; std::getline(lines, line);) {
        const Outcome outcome = run_line(line.substr(2));
        EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.out << outcome.err;
      }
    }
  }
  std::string read(const std::string& file) const { return read_text(folder_ / "work" / file); }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ / "work" / file) << text;
  }

 private:
  TempFolder folder_;
};

TEST(Tutorial, leads_to_an_event_a_scenario_a_plan_and_five_answers) {
  const Reader reader;
  const std::string tutorial = read_text(fs::path(LSOS_SOURCE_DIR) / "events/README.md");
  const std::size_t wrong = tutorial.find("## When it goes wrong");
  ASSERT_NE(wrong, std::string::npos);
  reader.follow(tutorial.substr(0, wrong));
  EXPECT_THAT(reader.read("out/beacons/overlay.kml"), HasSubstr("beacon"));

  const std::string event = reader.read("events/Beacon.lua");
  int cases = 0;
  for (std::size_t at = tutorial.find("\n| `", wrong); at != std::string::npos;
       at = tutorial.find("\n| `", at)) {
    const std::string right = between(tutorial, at, "`", "`");
    const std::string instead = between(tutorial, at, "`", "`");
    const std::string message = between(tutorial, at, "| ", " |");
    std::string broken = event;
    const std::size_t place = broken.find(right);
    ASSERT_NE(place, std::string::npos) << right;
    reader.write("events/Beacon.lua", broken.replace(place, right.size(), instead));
    const Outcome outcome = reader.run_line("lsos-host test");
    EXPECT_EQ(outcome.exit_code, 1) << instead;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr(message));
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("events/Beacon.lua:"));
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

TEST(Tutorial, leads_to_a_rover_that_differs_in_some_numbers) {
  const Reader reader;
  const std::string text = read_text(fs::path(LSOS_SOURCE_DIR) / "rovers/README.md");
  reader.follow(text.substr(text.find("## One of your own")));
  EXPECT_THAT(reader.read("rovers/SEV60.lua"), HasSubstr("efficiency = 0.32"));
  const Outcome outcome = reader.run_line("lsos-host test");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
}

}  // namespace
}  // namespace lsos::test
