// lua/README.md lists what is bound to Lua, and its example works.
#include <cstdlib>
#include <map>
#include <sstream>

#include "lua/session/reference.h"
#include "script_fixture.h"

namespace lsos {
namespace {

const char* const readme = LSOS_SOURCE_DIR "/lua/README.md";

TEST(Reference, is_the_readme) {
  if (std::getenv("LSOS_UPDATE_REFERENCE") != nullptr) std::ofstream(readme) << api_reference();
  std::ostringstream file;
  file << std::ifstream(readme).rdbuf();
  EXPECT_EQ(file.str(), api_reference())
      << "lua/README.md is out of date: LSOS_UPDATE_REFERENCE=1 with this test writes it anew";
}

TEST(Reference, is_the_library_of_editors) {
  const std::string library = LSOS_SOURCE_DIR "/lua/library.d.lua";
  if (std::getenv("LSOS_UPDATE_REFERENCE") != nullptr) std::ofstream(library) << api_library();
  std::ostringstream file;
  file << std::ifstream(library).rdbuf();
  EXPECT_EQ(file.str(), api_library())
      << "lua/library.d.lua is out of date: LSOS_UPDATE_REFERENCE=1 with this test writes it anew";
}

// Looks up, in a script, every member that the library lists for the module and a phase's objects.
TEST(Reference, is_what_scripts_find) {
  const std::map<std::string, std::string> classes{{"lsos", "lsos"},
                                                   {"lsos.rover", "rover"},
                                                   {"lsos.ev", "ev"},
                                                   {"lsos.rover.drive", "rover.drive"}};
  std::istringstream lines(api_library());
  std::string script, object;
  int found = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, name, type;
    words >> kind >> name >> type;
    if (kind == "---@class") object = classes.contains(name) ? classes.at(name) : "";
    if (kind != "---@field" || object.empty()) continue;
    EXPECT_FALSE(type.empty()) << line;
    if (object == "rover" || type.starts_with("fun(")) ++found;
    script += "local _ = " + object + "." + name + "\n";
  }
  EXPECT_GT(found, 60);
  EXPECT_EQ(EventRun::of_phase("do " + script + " end")->error(), "no error");
}

TEST(Reference, example_loads_and_runs) {
  const std::string text = api_reference();
  const std::size_t begin = text.find("```lua\n") + 7;
  const std::string example = text.substr(begin, text.find("```\n", begin) - begin);
  ScriptDirectory directory;
  directory.write("events/Twice.lua", example);
  const Catalog catalog(std::vector<ScriptFolder>{{directory.path(), ""}, {LSOS_SOURCE_DIR, ""}});
  ASSERT_EQ(errors_of(catalog, ScriptKind::event, "Twice"), "");
  LuaHost host(catalog);
  RecordingRover rover;
  PhaseContext context{rover, {}, {}, {}, {}, 0, "A", 1, "x"};
  EventArguments arguments;
  arguments.params = {{"duration_s", 90.0}};
  const ScriptInstance instance = host.begin("Twice", arguments);
  const auto answer = std::get<RunEvent>(host.run_phase(instance, "first", context));
  EXPECT_EQ(answer.type, "Pause");
  EXPECT_EQ(answer.next, "second");
  EXPECT_EQ(std::get<double>(answer.arguments.params.at("duration_s")), 90);
}

}  // namespace
}  // namespace lsos
