// What a folder from elsewhere may cost before anything runs: whatever its files are, the program
// ends soon, and says which file goes too far.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "system/bounded_folder.h"
#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

std::string pausing(const Fields& more = {}, const std::string& rover_type = "SEV") {
  Fields fields{{"Duration", "5 s"}};
  fields.insert(fields.end(), more.begin(), more.end());
  Mark rover = sev("A", "31,20");
  for (auto& [name, value] : rover.fields) {
    if (name == "RoverType") value = rover_type;
  }
  return kml({mission(), rover, event("Pause", "A", 1, fields)});
}

constexpr const char* event_begin = "local lsos = require 'lsos'\n";
constexpr const char* event_end =
    "\nreturn lsos.event { api = 1, doc = 'x', start = 'a', phases = { a = function() return text "
    "and lsos.done end } }\n";

class Bounded : public ::testing::TestWithParam<Folder> {};

TEST_P(Bounded, check_ends_soon) {
  const TempFolder folder;
  folder.write("plan.kml", pausing());
  expect_end(GetParam(), folder);
}

// A script beside the plan that the plan does not use, or does.
Folder script(const std::string& name, const std::string& file, const std::string& text,
              int exit_code = 0, const std::vector<std::string>& told = {}) {
  return {name, [=](const TempFolder& folder) { folder.write(file, text); }, exit_code, told};
}
Folder replaced_pause(const std::string& name, const std::string& text, const std::string& told) {
  return script(name, "events/Pause.lua", text, 2, {"events/Pause.lua", told});
}

const std::vector<Folder> scripts = {
    script("unused_script_of_many_terms", "events/Zz.lua", "return a" + repeated(" or a", 100'000)),
    script("unused_script_of_a_long_text", "rovers/Aa.lua",
           "return [[" + std::string(8 << 20, 'x') + "]]"),
    replaced_pause("script_of_many_terms", "return a" + repeated(" or a", 100'000),
                   "more than 1000 'and' and 'or' in one expression"),
    replaced_pause("script_of_many_branches",
                   "if a then" + repeated(" elseif a then", 50'000) + " end",
                   "more than 1000 'elseif' in one 'if'"),
    replaced_pause("script_of_deep_brackets", "return\n" + std::string(50'000, '('),
                   "Pause.lua:2: is nested too deeply"),
    replaced_pause("script_of_many_bytes", std::string(8 << 20, ' '), "is larger than 1 MiB"),
    {"scripts_that_loop",
     [](const TempFolder& folder) {
       for (int i = 0; i < 200; ++i)
         folder.write(fmt::format("events/L{}.lua", i), "for i = 1, 1e9 do end");
       folder.write("events/Pause.lua", event_begin + std::string("local text = 1") + event_end);
     },
     2,
     {"events/Pause.lua: is not loaded: the scripts of a folder may take 100 million "
      "instructions"}},
    {"scripts_that_keep_much",
     [](const TempFolder& folder) {
       for (int i = 0; i < 12; ++i) {
         folder.write(
             fmt::format("events/A{}.lua", i),
             event_begin +
                 std::string("local text = {} for i = 1, 8 do text[i] = ('x'):rep(2^20) .. i end") +
                 event_end);
       }
     }},
    {"more_scripts_than_are_allowed",
     [](const TempFolder& folder) {
       for (int i = 0; i <= 1000; ++i) folder.write(fmt::format("events/L{}.lua", i), "");
     },
     0,
     {"events: warning: has more than 1000 scripts; so many are allowed in one folder, and none is "
      "used"}},
    {"more_scripts_than_are_allowed_with_one_that_is_needed",
     [](const TempFolder& folder) {
       for (int i = 0; i <= 1000; ++i) folder.write(fmt::format("events/L{}.lua", i), "");
       folder.write("plan.kml", kml({mission(), sev("A", "31,20"), event("L7", "A", 1, {})}));
     },
     2,
     {"events: warning: has more than 1000 scripts", "'L7'"}},
    {"events_in_a_long_row",
     [](const TempFolder& folder) {
       for (int i = 0; i < 900; ++i) {
         folder.write(
             fmt::format("events/E{}.lua", i),
             fmt::format("return require 'lsos'.event {{ api = 1, doc = 'x', start = 'a', "
                         "phases = {{ a = require 'lsos'.sub_event {{ event = 'E{}' }} }} }}",
                         i + 1));
       }
     }},
};
INSTANTIATE_TEST_SUITE_P(Scripts, Bounded, ::testing::ValuesIn(scripts),
                         [](const auto& tested) { return tested.param.name; });

Folder link(const std::string& name, const std::string& target, const std::string& told) {
  return {name,
          [=](const TempFolder& folder) {
            fs::create_directory(folder / "events");
            fs::create_symlink(target, folder / "events/Pause.lua");
          },
          2,
          {"events/Pause.lua: ", told}};
}

Folder plan_is(const std::string& name, const std::function<void(const fs::path&)>& make,
               const std::string& told) {
  return {name,
          [=](const TempFolder& folder) {
            fs::remove(folder / "plan.kml");
            make(folder / "plan.kml");
          },
          2,
          {"plan.kml", told}};
}

const std::vector<Folder> files = {
    link("script_that_is_a_link_to_itself", "Pause.lua", "Too many levels of symbolic links"),
    link("script_that_leads_nowhere", "nothing", "No such file or directory"),
    link("script_that_is_a_device", "/dev/zero", "is a device or a terminal"),
    {"script_that_is_a_folder",
     [](const TempFolder& folder) { fs::create_directories(folder / "events/Pause.lua"); },
     2,
     {"events/Pause.lua: is a folder"}},
    {"script_that_is_a_pipe",
     [](const TempFolder& folder) {
       fs::create_directory(folder / "events");
       EXPECT_EQ(mkfifo((folder / "events/Pause.lua").c_str(), 0600), 0);
     },
     2,
     {"events/Pause.lua: is a pipe"}},
    {"script_of_100_gib",
     [](const TempFolder& folder) {
       fs::create_directory(folder / "events");
       make_sparse(folder / "events/Pause.lua");
     },
     2,
     {"events/Pause.lua: is larger than 1 MiB"}},
    {"unused_script_that_is_a_link_to_itself",
     [](const TempFolder& folder) {
       fs::create_directory(folder / "events");
       fs::create_symlink("Zz.lua", folder / "events/Zz.lua");
     }},
    {"unused_script_whose_name_is_no_text",
     [](const TempFolder& folder) { folder.write("events/Z\xff\x1b.lua", "x"); }},
    plan_is(
        "plan_that_is_a_device",
        [](const fs::path& plan) { fs::create_symlink("/dev/zero", plan); },
        "is a device or a terminal; a KML or KMZ file is wanted"),
    plan_is("plan_of_100_gib", make_sparse, "is larger than 256 MiB"),
    plan_is(
        "plan_that_is_a_link_to_itself",
        [](const fs::path& plan) { fs::create_symlink("plan.kml", plan); }, "symbolic links"),
};
INSTANTIATE_TEST_SUITE_P(Files, Bounded, ::testing::ValuesIn(files),
                         [](const auto& tested) { return tested.param.name; });

Folder plan(const std::string& name, const std::string& text, const std::string& told) {
  return {name, [=](const TempFolder& folder) { folder.write("plan.kml", text); }, 2, {told}};
}

// The SEV with other numbers, as a plan's own rover.
Folder rover(const std::string& name, const std::string& old, const std::string& changed,
             const std::string& told) {
  return {name,
          [=](const TempFolder& folder) {
            std::string text = read_text(fs::path(LSOS_SOURCE_DIR) / "rovers/SEV.lua");
            for (const auto& [from, to] :
                 {std::pair(old, changed), std::pair<std::string, std::string>("'SEV'", "'X'")}) {
              const std::size_t at = text.find(from);
              ASSERT_NE(at, std::string::npos);
              text.replace(at, from.size(), to);
            }
            folder.write("rovers/X.lua", text);
            folder.write("plan.kml", pausing({}, "X"));
          },
          2,
          {"rovers/X.lua", told}};
}

const std::vector<Folder> plans = {
    plan("condition_of_many_terms",
         pausing({{"WarnWhen", "charge &lt; 0.1" + repeated(" or charge &lt; 0.1", 40'000)}}),
         "a condition may have 4000"),
    plan(
        "more_rovers_than_are_allowed",
        [] {
          std::vector<Mark> marks{mission()};
          for (int i = 0; i <= 500; ++i) marks.push_back(sev(fmt::format("R{}", i), "31,20"));
          return kml(marks);
        }(),
        "has 501 rovers and assets; a plan may have 500: make several plans of it"),
    plan(
        "more_events_than_are_allowed",
        [] {
          std::vector<Mark> marks{mission(), sev("A", "31,20")};
          for (int i = 1; i <= 20'001; ++i) {
            marks.push_back(event("Pause", "A", i, {{"Duration", "5 s"}}));
          }
          return kml(marks);
        }(),
        "has 20001 events; a plan may have 20000: make several plans of some days each"),
    rover("wide_chassis", "vec(4.5, 2.0, 2.4)", "vec(4.5, 1e9, 2.4)", "100 m each is the most"),
    rover("far_wheels", "track_m      = 3.0", "track_m      = 1e9", "100 m is the most"),
    rover("many_wheels", "{ 0.2, -0.2 }",
          "(function() local t = {} for i = 1, 30000 do t[i] = i end return t end)()",
          "200 is the most"),
};
INSTANTIATE_TEST_SUITE_P(Plans, Bounded, ::testing::ValuesIn(plans),
                         [](const auto& tested) { return tested.param.name; });

TEST(BoundedList, shows_what_is_unreadable_and_what_is_not) {
  const TempFolder folder;
  fs::create_directory(folder / "events");
  fs::create_symlink("Zz.lua", folder / "events/Zz.lua");
  const Outcome outcome = run_bounded({"list", "events"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Pause"));
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("events/Zz.lua"));
}

// While a long text is there, an instruction of the script that can compare it counts more.
TEST(BoundedList, long_text_of_one_script_makes_no_other_dearer) {
  const TempFolder folder;
  folder.write("events/Aa.lua",
               event_begin + ("local text = [[" + std::string(900'000, 'x') + "]]") + event_end);
  const Outcome outcome = run_bounded({"list", "terrains"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("BlackPoint"));
  EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("cannot be used")));
}

// Each folder of scripts has limits of its own.
TEST(BoundedPath, is_not_charged_with_scripts_of_the_plan) {
  const TempFolder folder;
  for (int i = 0; i < 200; ++i) {
    folder.write(fmt::format("plan/events/L{}.lua", i), "for i = 1, 1e9 do end");
  }
  folder.write("plan/events/Zy.lua", event_begin + std::string("local text = 1") + event_end);
  folder.write("site/events/Zz.lua", event_begin + std::string("local text = 1") + event_end);
  const auto check = [&](const std::string& type) {
    folder.write("plan/plan.kml", kml({mission(), sev("A", "31,20"), event(type, "A", 1, {})}));
    return run_bounded({"check", "plan/plan.kml"},
                       {.folder = folder.path(), .environment = {"LSOS_PATH=site"}});
  };
  EXPECT_THAT(check("Zy").out,
              HasSubstr("Zy.lua: is not loaded: the scripts of a folder may take"));
  const Outcome of_site = check("Zz");
  EXPECT_EQ(of_site.exit_code, 0) << of_site.out << of_site.err;
}

TEST(BoundedPath, may_have_thousands_of_folders) {
  const TempFolder folder;
  std::string path = "LSOS_PATH=last";
  for (int i = 0; i < 16'000; ++i) path += fmt::format(":n{}", i);  // none of which is there
  folder.write("last/events/Zz.lua", event_begin + std::string("local text = 1") + event_end);
  const Outcome outcome =
      run_bounded({"list", "events"}, {.folder = folder.path(), .environment = {path}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("Zz"));
}

}  // namespace
}  // namespace lsos::test
