// The printed scripts with another program in place of lsos-host, which says how a task has ended.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "base/replaced.h"
#include "system/cluster_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

class ClusterScript : public ClusterFolder {
 protected:
  ClusterScript() { odd += "\\x"; }

  void SetUp() override {
    ClusterFolder::SetUp();
    // Notes its words and ends with $CODE; with $WAITS not until it is told to.
    write_program("cases", R"(echo "in $PWD" >> "$NOTES"
printf '<%s>\n' "$@" >> "$NOTES"
if [ "$2" = gather ]; then exit; fi
if [ -n "$WAITS" ]; then
  trap 'exit $CODE' TERM
  : > "$NOTES.waits"
  for i in $(seq 600); do sleep 0.1; done
fi
exit $CODE
)");
    write_program("scontrol", "echo \"scontrol $*\" >> \"$NOTES\"\n");
    write_program("squeue", "cat \"$NOTES.state\"\n");
  }

  // The script of an engine in a file, for the other program.
  std::string script(const std::string& engine, const Words& words = {}) {
    const std::string text =
        replaced(read_text(printed(engine, words)), LSOS_PROGRAM, (temp() / "bin/cases").string());
    write(engine + ".sh", text);
    return folder() / (engine + ".sh");
  }
  Surroundings with(Words environment) const {
    environment.push_back("NOTES=" + (temp() / "notes").string());
    return here(environment);
  }
  Outcome run_script(const std::string& file, const Words& environment) const {
    return run_command({"bash", file}, with(environment));
  }
  std::string notes() const { return read_text(temp() / "notes"); }

  void temp_write(const std::string& name, const std::string& text) const {
    std::ofstream(temp() / name) << text;
  }

  // Sends signals to the script of a Slurm task while its cases run.
  Outcome signalled(const std::string& file, const std::string& code,
                    const std::vector<int>& signals) {
    fs::remove(temp() / "notes");
    fs::remove(temp() / "notes.waits");
    Process task({"bash", file}, with({"CODE=" + code, "WAITS=1", "SLURM_ARRAY_JOB_ID=7",
                                       "SLURM_ARRAY_TASK_ID=1"}));
    for (int i = 0; i < 1000 && !fs::exists(temp() / "notes.waits"); ++i) pause_ms(10);
    for (const int signal : signals) {
      task.signal(signal);
      pause_ms(20);
    }
    return task.wait();
  }
  static void pause_ms(int time) { std::this_thread::sleep_for(std::chrono::milliseconds(time)); }
};

TEST_F(ClusterScript, of_slurm_goes_back_into_the_queue_only_where_that_helps) {
  const std::string file = script("slurm");
  const Outcome further = signalled(file, "143", {SIGUSR1});
  EXPECT_EQ(further.exit_code, 143) << further.err;
  EXPECT_THAT(notes(), HasSubstr("scontrol requeue 7_1"));
  const Outcome no_further = signalled(file, "75", {SIGUSR1});
  EXPECT_EQ(no_further.exit_code, 75);
  EXPECT_THAT(no_further.err, HasSubstr("task 1: no progress within --time: give more"));
  EXPECT_THAT(notes(), Not(HasSubstr("requeue")));
  EXPECT_EQ(signalled(file, "0", {SIGUSR1}).exit_code, 0);
  EXPECT_THAT(notes(), Not(HasSubstr("requeue"))) << "it was done";
}

// Cases that have not stopped yet when the second of two signals comes.
constexpr const char* slow_to_stop = R"(trap 'sleep 0.3; exit 143' TERM
: > "$NOTES.waits"
for i in $(seq 600); do sleep 0.1; done
)";

// As at the end of a task's time.
TEST_F(ClusterScript, of_slurm_goes_back_though_it_is_told_twice) {
  const std::string file = script("slurm");
  write_program("cases", slow_to_stop);
  temp_write("notes.state", "TimeLimit\n");
  EXPECT_EQ(signalled(file, "143", {SIGUSR1, SIGTERM}).exit_code, 143);
  EXPECT_THAT(notes(), HasSubstr("scontrol requeue 7_1"));
}

// The words are those of Slurm 22.05.
TEST_F(ClusterScript, of_slurm_knows_why_it_is_ended) {
  const std::string file = script("slurm");
  write_program("cases", slow_to_stop);
  const auto goes_back = [&](const std::string& state, const std::vector<int>& signals) {
    temp_write("notes.state", state);
    EXPECT_EQ(signalled(file, "143", signals).exit_code, 143);
    return notes().find("scontrol requeue 7_1") != std::string::npos;
  };
  EXPECT_FALSE(goes_back("None\n", {SIGTERM})) << "scancel";
  EXPECT_FALSE(goes_back("None\n", {SIGUSR1, SIGTERM})) << "scancel near its end";
  EXPECT_TRUE(goes_back("TimeLimit\n", {SIGTERM})) << "its time is over";
  EXPECT_FALSE(goes_back("", {SIGTERM})) << "squeue does not answer";
}

TEST_F(ClusterScript, can_be_told_before_its_cases_run) {
  const std::string file = script("slurm");
  // What finds the cases of a task comes before them, and takes a while.
  write_program("sed", ": > \"$NOTES.waits\"\nsleep 0.3\necho 1-4\n");
  const Outcome told = signalled(file, "75", {SIGUSR1});
  EXPECT_EQ(told.exit_code, 75) << "not killed: " << told.err;
  EXPECT_THAT(told.err, HasSubstr("give more"));
}

TEST_F(ClusterScript, refuses_a_task_that_it_does_not_have) {
  const std::string slurm = script("slurm"), sge = script("sge");
  const Outcome none = run_script(slurm, {"CODE=0"});
  EXPECT_NE(none.exit_code, 0);
  EXPECT_THAT(none.err, HasSubstr("is missing: this is for sbatch --array"));
  const Outcome late = run_script(slurm, {"CODE=0", "SLURM_ARRAY_TASK_ID=2"});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.err, HasSubstr("task 2 after 0: this script has no such task"));
  const Outcome other = run_script(sge, {"CODE=0", "SGE_TASK_ID=2"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.err, HasSubstr("task 2: this script has no such task"));
  EXPECT_FALSE(fs::exists(temp() / "notes")) << "no case has run";
  EXPECT_EQ(run_script(script("pbs"), {"CODE=0", "PBS_ARRAY_INDEX=2"}).exit_code, 0)
      << "no array has one task";
}

TEST_F(ClusterScript, of_grid_engine_goes_back_into_the_queue_only_where_that_helps) {
  const std::string file = script("sge", {"--time", "1:00:00"});
  EXPECT_EQ(run_script(file, {"SGE_TASK_ID=1", "CODE=143"}).exit_code, 99);
  const Outcome no_further = run_script(file, {"SGE_TASK_ID=1", "CODE=75"});
  EXPECT_EQ(no_further.exit_code, 75);
  EXPECT_THAT(no_further.err, HasSubstr("task 1: no progress within --time: give more"));
  EXPECT_EQ(run_script(file, {"SGE_TASK_ID=1", "CODE=1"}).exit_code, 1);
}

TEST_F(ClusterScript, tries_those_that_could_not_be_run_only_the_first_time) {
  const Words retry{"--retry", "failed"};
  const std::string words = "<--retry>\n<failed>\n";
  const auto notes_of = [&](const std::string& engine, const Words& environment) {
    fs::remove(temp() / "notes");
    Words all = environment;
    all.push_back("CODE=0");
    run_script(script(engine, retry), all);
    return notes();
  };
  const std::string slurm = "SLURM_ARRAY_TASK_ID=1", sge = "SGE_TASK_ID=1";
  EXPECT_THAT(notes_of("slurm", {slurm}), HasSubstr(words));
  EXPECT_THAT(notes_of("slurm", {slurm, "SLURM_RESTART_COUNT=1"}), Not(HasSubstr("<--retry>")));
  EXPECT_THAT(notes_of("sge", {sge, "RESTARTED=0"}), HasSubstr(words));
  EXPECT_THAT(notes_of("sge", {sge, "RESTARTED=1"}), Not(HasSubstr("<--retry>")));
  EXPECT_THAT(notes_of("pbs", {"PBS_ARRAY_INDEX=1"}), HasSubstr(words));
  EXPECT_THAT(read_text(printed("condor", retry)), HasSubstr(" --retry failed --cases $(task)\""));
}

class ParallelScript : public ClusterScript {
 protected:
  void SetUp() override {
    ClusterScript::SetUp();
    if (run_command({"parallel", "--version"}).out.find("GNU parallel") == std::string::npos) {
      GTEST_SKIP() << "GNU parallel is not installed: script/bootstrap long";
    }
  }
};

// The name of its folder has what parallel would replace, or run.
TEST_F(ParallelScript, keeps_names_as_they_are) {
  const Outcome outcome = run_script(script("parallel", {"--chunk", "2"}), {"CODE=0"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string ours = "in " + folder().string() + "\n<sweep>\n<run>\n<" +
                           (folder() / "my study.lua").string() + ">\n";
  EXPECT_THAT(notes(), HasSubstr(ours));
  EXPECT_THAT(notes(), HasSubstr("<--cases>\n<1-2>\n"));
  EXPECT_THAT(notes(), HasSubstr("<--cases>\n<3-4>\n"));
  EXPECT_THAT(notes(), HasSubstr("<gather>\n"));
  EXPECT_EQ(run_script(folder() / "parallel.sh", {"CODE=1"}).exit_code, 2) << "of tasks";
}

// As on another machine: neither the folder nor the variables of this one are there.
TEST_F(ParallelScript, runs_on_other_machines) {
  write_program("ssh", R"(echo "ssh $*" >> "$NOTES"
while [ "$1" != -- ] && [ $# -gt 1 ]; do shift; done
shift
cd /
exec env -i SHELL=/bin/bash PATH="$PATH" NOTES="$NOTES" CODE="$CODE" /bin/bash -c "$*"
)");
  const Outcome outcome =
      run_script(script("parallel", {"--chunk", "2"}), {"CODE=0", "PARALLEL=-S 2/there"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(notes(), HasSubstr("ssh "));
  EXPECT_THAT(notes(), HasSubstr("in " + folder().string() + "\n<sweep>\n<run>\n"));
  EXPECT_THAT(notes(), HasSubstr("<--cases>\n<3-4>\n"));
}

TEST_F(ClusterScript, of_parallel_ends_as_its_tasks_have) {
  write_program("parallel", "echo \"parallel $*\" >> \"$NOTES\"\nexit $CODE\n");
  write_program("nproc", "echo 8\n");
  EXPECT_EQ(run_script(script("parallel"), {"CODE=3"}).exit_code, 3);
  EXPECT_THAT(notes(), HasSubstr("--jobs 8 "));
  EXPECT_THAT(notes(), HasSubstr("<gather>"));
  EXPECT_EQ(run_script(script("parallel", {"-j", "4"}), {"CODE=0"}).exit_code, 0);
  EXPECT_THAT(notes(), HasSubstr("--jobs 2 ")) << "tasks of 4 processors each";
  run_script(script("parallel", {"-j", "16"}), {"CODE=0"});
  EXPECT_THAT(notes(), HasSubstr("--jobs 1 "));
  run_script(script("parallel", {"-j", "4", "--limit", "7"}), {"CODE=0"});
  EXPECT_THAT(notes(), HasSubstr("--jobs 7 "));
}

TEST_F(ClusterScript, of_condor_is_refused_for_a_folder_that_it_cannot_name) {
  for (const char* name : {"ends in \\", "ends in a blank "}) {
    const fs::path other = folder() / name;
    fs::create_directories(other);
    const Outcome outcome =
        run({"sweep", "../my study.lua", "--print", "condor"}, {.folder = other});
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_THAT(outcome.err, HasSubstr("its name ends in a backslash or a blank"));
  }
}

}  // namespace
}  // namespace lsos::test
