// What a folder from elsewhere may cost before anything runs: whatever its files are, the program
// ends soon, and says which file goes too far.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "system/plan_text.h"
#include "system/process.h"
#include "system/temp_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

// Runs the program with 4 GB of address space; it is killed after two minutes, far more than it
// takes.
Outcome run_bounded(const Words& arguments, const Surroundings& where) {
  Words words{"prlimit", "--as=4200000000", "timeout", "-s", "KILL", "120"};
  const Words own = program(arguments);
  words.insert(words.end(), own.begin(), own.end());
  return run_command(words, where);
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

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

// A folder, and what `check` says of the plan in it.
struct Folder {
  std::string name;
  std::function<void(const TempFolder&)> fill;  // besides plan.kml, which it may replace
  int exit_code = 0;
  std::vector<std::string> told = {};
};

void PrintTo(const Folder& folder, std::ostream* out) { *out << folder.name; }

class Bounded : public ::testing::TestWithParam<Folder> {};

TEST_P(Bounded, check_ends_soon) {
  const TempFolder folder;
  folder.write("plan.kml", pausing());
  GetParam().fill(folder);
  const Outcome outcome = run_bounded({"check", "plan.kml"}, {.folder = folder.path()});
  EXPECT_EQ(outcome.exit_code, GetParam().exit_code)
      << outcome.out.substr(0, 500) << outcome.err.substr(0, 500);
  for (const std::string& told : GetParam().told) {
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr(told));
  }
  EXPECT_LT(outcome.out.size() + outcome.err.size(), 100'000U);
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
     {"events/Pause.lua: is not loaded: scripts may take 100 million instructions together"}},
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
     2,
     {"events: has more than 1000 scripts"}},
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

constexpr std::uintmax_t hundred_gib = std::uintmax_t{100} << 30;

void make_sparse(const fs::path& file) {
  EXPECT_EQ(mknod(file.c_str(), S_IFREG | 0600, 0), 0);
  fs::resize_file(file, hundred_gib);
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
        "has 501 rovers and assets; a plan may have 500"),
    rover("wide_chassis", "vec(4.5, 2.0, 2.4)", "vec(4.5, 1e9, 2.4)", "100 m each is the most"),
    rover("far_wheels", "track_m      = 3.0", "track_m      = 1e9", "100 m is the most"),
    rover("many_wheels", "{ 0.2, -0.2 }",
          "(function() local t = {} for i = 1, 30000 do t[i] = i end return t end)()",
          "200 is the most"),
};
INSTANTIATE_TEST_SUITE_P(Plans, Bounded, ::testing::ValuesIn(plans),
                         [](const auto& tested) { return tested.param.name; });

constexpr const char* crs_of_moon =
    "GEOGCS[\"Moon\",DATUM[\"D_Moon\",SPHEROID[\"Moon\",1737400,0]],PRIMEM[\"Reference\",0],"
    "UNIT[\"Degree\",0.0174532925199433]]";

// Level ground around longitude 31, latitude 20.
void write_raster(const TempFolder& folder) {
  folder.write("dem.asc", "ncols 40\nnrows 40\nxllcorner 30.98\nyllcorner 19.98\ncellsize 0.001\n" +
                              repeated(repeated("100 ", 40) + "\n", 40));
  folder.write("dem.prj", crs_of_moon);
}

std::string vrt_of(const std::vector<std::string>& sources, std::int64_t cells = 40) {
  std::string bands;
  for (const std::string& source : sources) {
    bands += fmt::format(
        "<SimpleSource><SourceFilename relativeToVRT='1'>{}</SourceFilename>"
        "<SourceBand>1</SourceBand></SimpleSource>",
        source);
  }
  return fmt::format(
      "<VRTDataset rasterXSize='{0}' rasterYSize='{0}'><SRS>{1}</SRS>"
      "<GeoTransform>30.98, 0.001, 0, 20.02, 0, -0.001</GeoTransform>"
      "<VRTRasterBand dataType='Float32' band='1'>{2}</VRTRasterBand></VRTDataset>",
      cells, crs_of_moon, bands);
}

Folder on_ground(const std::string& name, const std::string& raster,
                 const std::function<void(const TempFolder&)>& fill, int exit_code,
                 const std::vector<std::string>& told) {
  return {name,
          [=](const TempFolder& folder) {
            write_raster(folder);
            fill(folder);
            folder.write(
                "plan.kml",
                kml({{"MissionInfo",
                      {{"Planet", "Moon"}, {"StartTime", "2026-07-01"}, {"Terrain", raster}},
                      ""},
                     sev("A", "31,20"),
                     event("Pause", "A", 1, {{"Duration", "5 s"}})}));
          },
          exit_code, told};
}

const std::vector<Folder> grounds = {
    on_ground("vrts_that_name_each_other", "v0a.vrt",
              [](const TempFolder& folder) {
                constexpr int depth = 22;
                for (int i = 0; i < depth; ++i) {
                  for (const char side : {'a', 'b'}) {
                    folder.write(fmt::format("v{}{}.vrt", i, side),
                                 i + 1 == depth ? vrt_of({"dem.asc"})
                                                : vrt_of({fmt::format("v{}a.vrt", i + 1),
                                                          fmt::format("v{}b.vrt", i + 1)}));
                  }
                }
              },
              2, {"v0a.vrt", "it opens more than 1000 VRTs at once"}),
    on_ground("vrts_in_a_circle", "v0.vrt",
              [](const TempFolder& folder) {
                folder.write("v0.vrt", vrt_of({"v1.vrt"}));
                folder.write("v1.vrt", vrt_of({"v0.vrt"}));
              },
              2, {"v0.vrt", "cannot be read: Recursion detected"}),
    on_ground("vrt_of_some_vrts", "v0.vrt",
              [](const TempFolder& folder) {
                folder.write("v0.vrt", vrt_of({"v1.vrt", "v1.vrt", "./v1.vrt"}));
                folder.write("v1.vrt", vrt_of({"dem.asc", "./dem.asc"}));
              },
              0, {}),
    on_ground("raster_of_more_cells_than_can_be_counted", "v0.vrt",
              [](const TempFolder& folder) { folder.write("v0.vrt", vrt_of({}, 2'147'483'647)); },
              2, {"v0.vrt", "1000000000 x 1000000000 are the most"}),
    on_ground("raster_with_a_pipe_beside_it", "dem.asc",
              [](const TempFolder& folder) {
                fs::remove(folder / "dem.prj");
                EXPECT_EQ(mkfifo((folder / "dem.prj").c_str(), 0600), 0);
              },
              2, {"dem.asc"}),
    on_ground("raster_with_a_text_of_100_gib_beside_it", "dem.asc",
              [](const TempFolder& folder) {
                fs::remove(folder / "dem.prj");
                make_sparse(folder / "dem.prj");
              },
              2, {"dem.asc"}),
};
INSTANTIATE_TEST_SUITE_P(Grounds, Bounded, ::testing::ValuesIn(grounds),
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
