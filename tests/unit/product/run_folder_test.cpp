// The rules for changing a folder, each with its message.
#include "product/run_folder.h"

#include <gmock/gmock.h>

#include <set>
#include <vector>

#include "base/error.h"
#include "base/files.h"
#include "product/summary.h"
#include "unit/record/log_fixture.h"

namespace lsos {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string refusal_of(const std::string& path, bool force = false) {
  try {
    const RunFolder folder(path, force);
    return "not refused";
  } catch (const InputError& error) {
    return error.what();
  }
}

// Begins a new run in place of an earlier one.
void begin(RunFolder&& run) {
  run.prepare();
  run.settle();
}
void begin(RunFolder& run) { begin(std::move(run)); }

void write_finished_run(const std::string& path) {
  RunFolder run(path, false);
  begin(run);
  write_file(run.file("log.gpkg"), "log");
  write_file(run.file("overlay.kml"), "overlay");
  write_file(run.file("plan.kml"), "plan");
  write_summary(path, {});
}

TEST(RunFolder, is_named_after_the_plan) {
  EXPECT_EQ(default_run_folder("plans/south.pole.kml"), "out/south.pole");
  EXPECT_EQ(default_run_folder("a.kmz"), "out/a");
}

TEST(RunFolder, is_made_with_its_parents) {
  const TestFolder folder;
  write_finished_run(folder / "out/a");
  EXPECT_TRUE(fs::exists(folder / "out/a/summary.json"));
  EXPECT_FALSE(fs::exists(folder / "out/a/.lsos-host.lock"));
}

TEST(RunFolder, leaves_nothing_when_the_run_did_not_begin) {
  const TestFolder folder;
  { const RunFolder run(folder / "out/a", false); }
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(RunFolder, replaces_a_finished_run_only_when_told) {
  const TestFolder folder;
  const std::string path = folder / "a";
  write_finished_run(path);
  write_file(path + "/my notes.txt", "mine");
  {
    const RunFolder run(path, false);
    EXPECT_TRUE(fs::exists(path + "/summary.json"));
  }
  EXPECT_TRUE(fs::exists(path + "/log.gpkg"));
  RunFolder run(path, false);
  begin(run);
  for (const char* name : {"log.gpkg", "overlay.kml", "plan.kml", "summary.json"}) {
    EXPECT_FALSE(fs::exists(run.file(name))) << name;
  }
  EXPECT_EQ(read_file(path + "/my notes.txt"), "mine");
}

TEST(RunFolder, gives_an_earlier_run_back_when_the_new_one_fails_to_begin) {
  const TestFolder folder;
  const std::string path = folder / "a";
  write_finished_run(path);
  {
    RunFolder run(path, false);
    run.prepare();
    EXPECT_FALSE(fs::exists(run.file("summary.json")));
    write_file(run.file("log.gpkg"), "new");
    run.discard();
  }
  EXPECT_EQ(read_file(path + "/log.gpkg"), "log");
  EXPECT_EQ(std::distance(fs::directory_iterator(path), {}), 4) << "as it was";
  EXPECT_EQ(refusal_of(path), "not refused") << "the run in it has finished";
  {
    RunFolder run(path, false);
    run.prepare();
    write_file(run.file("log.gpkg"), "new");
    run.settle();
    write_summary(path, {});
  }
  EXPECT_EQ(read_file(path + "/log.gpkg"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(path), {}), 2) << "log and summary";
}

// Whatever was moved when the kill came: all files but the log, or all of them, or some were put
// back already.
TEST(RunFolder, takes_an_earlier_run_back_when_the_new_one_was_killed_while_it_began) {
  const std::vector<std::string> names{"log.gpkg", "overlay.kml", "plan.kml", "summary.json"};
  const TestFolder folder;
  int number = 0;
  const auto expect_taken_back = [&](const std::set<std::string>& aside, bool has_new_log) {
    const std::string path = folder / std::to_string(number++);
    write_finished_run(path);
    fs::create_directory(path + "/.lsos-host.earlier");
    for (const std::string& name : aside) {
      fs::rename(path + "/" + name, path + "/.lsos-host.earlier/" + name);
    }
    if (has_new_log) {
      write_file(path + "/log.gpkg", "half");
      write_file(path + "/log.gpkg-wal", "half");
      write_file(path + "/plan.kml", "other");
    }
    write_file(path + "/.lsos-host.lock", "a run of lsos-host that has not finished\n");
    EXPECT_EQ(refusal_of(path), "not refused") << "the run in it has finished";
    EXPECT_EQ(read_file(path + "/log.gpkg"), "log");
    EXPECT_EQ(read_file(path + "/plan.kml"), "plan");
    for (const std::string& name : names) EXPECT_TRUE(fs::exists(path + "/" + name)) << name;
    EXPECT_FALSE(fs::exists(path + "/log.gpkg-wal"));
    EXPECT_FALSE(fs::exists(path + "/.lsos-host.earlier"));
  };
  expect_taken_back({}, false);
  expect_taken_back({"summary.json", "overlay.kml"}, false);
  expect_taken_back({"summary.json", "overlay.kml", "plan.kml"}, false);
  expect_taken_back({names.begin(), names.end()}, false);
  expect_taken_back({names.begin(), names.end()}, true);
}

TEST(RunFolder, removes_a_replaced_run_when_a_kill_came_meanwhile) {
  const TestFolder folder;
  const std::string path = folder / "a";
  write_finished_run(path);
  fs::create_directory(path + "/.lsos-host.replaced");
  write_file(path + "/.lsos-host.replaced/log.gpkg", "old");
  EXPECT_EQ(refusal_of(path), "not refused");
  EXPECT_EQ(read_file(path + "/log.gpkg"), "log") << "that of the run that replaced it";
  EXPECT_FALSE(fs::exists(path + "/.lsos-host.replaced"));
}

TEST(RunFolder, refuses_an_unfinished_run_unless_forced) {
  const TestFolder folder;
  const std::string path = folder / "a";
  begin(RunFolder(path, false));
  EXPECT_THAT(refusal_of(path), HasSubstr("a: holds a run that has not finished; --force"));
  EXPECT_THAT(refusal_of(path), HasSubstr("--force")) << "looking changes nothing";
  EXPECT_EQ(refusal_of(path, true), "not refused");
}

TEST(RunFolder, knows_an_unfinished_run_by_its_log) {
  const TestFolder folder;
  const std::string path = folder / "a";
  fs::create_directory(path);
  { LogWriter(path + "/log.gpkg", moon_crs, test_start()).commit(); }
  EXPECT_THAT(refusal_of(path), HasSubstr("--force"));
  RunFolder run(path, true);
  begin(run);
  EXPECT_FALSE(fs::exists(path + "/log.gpkg"));
}

TEST(RunFolder, never_touches_what_is_not_ours) {
  const TestFolder folder;
  for (const char* name : {"plan.kml", "log.gpkg", "summary.json", "thesis.doc"}) {
    const std::string path = folder / (std::string("with ") + name);
    fs::create_directory(path);
    write_file(path + "/" + name, "theirs");
    for (const bool force : {false, true}) {
      EXPECT_THAT(refusal_of(path, force), HasSubstr("no run of lsos-host")) << name;
    }
    EXPECT_EQ(read_file(path + "/" + name), "theirs");
    EXPECT_EQ(std::distance(fs::directory_iterator(path), {}), 1) << name;
  }
}

TEST(RunFolder, follows_no_link_out_of_the_folder) {
  const TestFolder folder;
  write_finished_run(folder / "other");
  const std::string path = folder / "a";
  write_finished_run(path);
  fs::remove(path + "/log.gpkg");
  fs::create_symlink(folder / "other/log.gpkg", path + "/log.gpkg");
  EXPECT_THAT(refusal_of(path, true), HasSubstr("no run of lsos-host"));
  EXPECT_TRUE(fs::exists(folder / "other/log.gpkg"));
}

// Each name that the program itself would write to, read or move files into.
TEST(RunFolder, follows_no_link_of_its_own_names) {
  const TestFolder folder;
  fs::create_directory(folder / "victim");
  write_file(folder / "victim/log.gpkg", "theirs");
  int number = 0;
  for (const char* name : {"log.gpkg-journal", "log.gpkg-wal", ".lsos-host.lock",
                           ".lsos-host.earlier", ".lsos-host.replaced", "days.csv"}) {
    for (const char* target : {"victim/log.gpkg", "victim", "victim/none"}) {
      const std::string path = folder / std::to_string(number++);
      write_finished_run(path);
      fs::create_symlink(folder / target, path + "/" + name);
      EXPECT_THAT(refusal_of(path, true), HasSubstr("no run of lsos-host")) << name << target;
      EXPECT_EQ(read_file(path + "/log.gpkg"), "log") << "the run stays";
    }
  }
  EXPECT_EQ(read_file(folder / "victim/log.gpkg"), "theirs");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "victim"), {}), 1);
}

TEST(RunFolder, is_no_link) {
  const TestFolder folder;
  fs::create_directory(folder / "victim");
  fs::create_directory_symlink(folder / "victim", folder / "a");
  EXPECT_THAT(refusal_of(folder / "a", true), HasSubstr("a: is a link, to "));
  EXPECT_THAT(refusal_of(folder / "a/", true), HasSubstr("nothing is written through it"));
  fs::create_directory_symlink(folder / "none", folder / "b");
  EXPECT_THAT(refusal_of(folder / "b", true), HasSubstr("b: is a link, to "));
  EXPECT_TRUE(fs::is_empty(folder / "victim"));
}

TEST(RunFolder, writes_into_no_other_lock_file) {
  const TestFolder folder;
  const std::string path = folder / "a", lock = path + "/.lsos-host.lock";
  write_finished_run(path);
  write_file(lock, "a diary");
  EXPECT_THAT(refusal_of(path, true), HasSubstr("no run of lsos-host"));
  EXPECT_EQ(read_file(lock), "a diary");
  fs::remove(lock);
  write_file(folder / "empty", "");
  fs::create_hard_link(folder / "empty", lock);
  EXPECT_THAT(refusal_of(path, true), HasSubstr("no run of lsos-host"));
  EXPECT_EQ(read_file(folder / "empty"), "");
}

TEST(RunFolder, leaves_what_others_put_into_its_folders) {
  for (const char* name : {".lsos-host.earlier", ".lsos-host.replaced"}) {
    const TestFolder folder;
    const std::string path = folder / "a";
    write_finished_run(path);
    fs::create_directory(path + "/" + name);
    write_file(path + "/" + name + "/notes.txt", "mine");
    EXPECT_THAT(refusal_of(path, true), HasSubstr("no run of lsos-host")) << name;
    EXPECT_EQ(read_file(path + "/" + name + "/notes.txt"), "mine");
  }
}

TEST(RunFolder, is_cleared_of_the_run_alone) {
  const TestFolder folder;
  for (const bool has_notes : {false, true}) {
    const std::string path = folder / "a";
    write_finished_run(path);
    if (has_notes) write_file(path + "/notes.txt", "mine");
    RunFolder(path, true).clear();
    EXPECT_EQ(fs::exists(path), has_notes);
  }
  EXPECT_EQ(read_file(folder / "a/notes.txt"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "a"), {}), 1);
}

TEST(RunFolder, refuses_a_file) {
  const TestFolder folder;
  write_file(folder / "a", "theirs");
  EXPECT_THAT(refusal_of(folder / "a", true), HasSubstr("a: is a file, not a folder"));
  EXPECT_THAT(refusal_of(folder / "a/b", true), HasSubstr("cannot be the folder of a run"));
  EXPECT_EQ(read_file(folder / "a"), "theirs");
}

TEST(RunFolder, keeps_out_a_second_writer) {
  const TestFolder folder;
  const std::string path = folder / "a";
  {
    RunFolder first(path, false);
    EXPECT_THAT(refusal_of(path), HasSubstr("another lsos-host is writing there"));
    begin(first);
    EXPECT_THAT(refusal_of(path, true), HasSubstr("another lsos-host is writing there"));
    write_summary(path, {});
  }
  EXPECT_EQ(refusal_of(path), "not refused");
}

TEST(RunFolder, gives_back_nothing_before_all_was_kept) {
  const TestFolder folder;
  const std::string path = folder / "a";
  write_finished_run(path);
  RunFolder run(path, false);
  run.discard();
  EXPECT_EQ(read_file(path + "/log.gpkg"), "log") << "the earlier run was not moved yet";
}

TEST(RunFolder, removes_what_a_kill_left_half_written) {
  const TestFolder folder;
  const std::string path = folder / "a";
  begin(RunFolder(path, false));
  write_file(path + "/overlay.kml.lsos-host.part", "half");
  write_file(path + "/report.html.part", "a download");
  fs::create_directory(path + "/summary.json.lsos-host.part");
  RunFolder run(path, true);
  begin(run);
  EXPECT_FALSE(fs::exists(path + "/overlay.kml.lsos-host.part"));
  EXPECT_EQ(read_file(path + "/report.html.part"), "a download");
  EXPECT_TRUE(fs::exists(path + "/summary.json.lsos-host.part")) << "no file of ours";
}

}  // namespace
}  // namespace lsos
