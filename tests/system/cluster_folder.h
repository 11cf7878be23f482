// Studies on a cluster: a study in a folder with a difficult name, and an sbatch that runs at once
// what it is given.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "system/study_text.h"

namespace lsos::test {

class ClusterFolder : public ::testing::Test {
 protected:
  void SetUp() override { write_study(4); }

  void write_study(int cases, const std::string& keys = "") {
    write("my study.lua",
          study_text("cases = " + std::to_string(cases) + ", sampling = 'sobol'," + keys,
                     "lsos.vary { of = 'A/10.Speed', uniform = { '0.5 m/s', '1.5 m/s' } }"));
    write("plan.kml", kml(short_plan()));
  }

  // A case takes some 30 s of a processor by its speed in m/s.
  void write_long_study(const std::string& speeds) {
    std::string laps = "0,0";
    for (int lap = 0; lap < 6; ++lap) laps += " 0.03,0 0.03,0.03 0,0.03 0,0";
    write("plan.kml", kml({mission({{"LogInterval", "60"}}), sev("A", "0,0"),
                           event("Route", "A", 10, {{"Speed", "2"}}, line(laps))}));
    write("my study.lua", study_text("sampling = 'grid',",
                                     "lsos.vary { of = 'A/10.Speed', list = { " + speeds + " } }"));
  }

  // The folder's name. Slurm takes none with a backslash.
  std::string odd = "-it's 100% \"odd\" $HOME {} {= die =};";

  std::filesystem::path folder() const { return temp_ / odd; }
  std::filesystem::path temp() const { return temp_.path(); }
  void write(const std::string& name, const std::string& text) {
    temp_.write(odd + "/" + name, text);
  }

  // A program in a folder that comes first in PATH.
  void write_program(const std::string& name, const std::string& text) {
    const std::string file = temp_.write("bin/" + name, "#!/bin/bash\n" + text);
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  Surroundings here(Words environment = {}) const {
    environment.push_back("PATH=" + (temp_ / "bin").string() + ":" + std::getenv("PATH"));
    return {.folder = folder(), .environment = environment};
  }

  Outcome sweep(Words words, const Words& environment = {}) const {
    words.insert(words.begin(), {"sweep", "my study.lua", "--quiet"});
    return run(words, here(environment));
  }
  // The script that `--print` has printed, in a file.
  std::string printed(const std::string& engine, Words words = {}) const {
    words.insert(words.begin(), {"--print", engine});
    const Outcome outcome = sweep(words, {"LSOS_PATH=a b:it's"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return temp_.write(engine + ".job", outcome.out);
  }

  // A Slurm that runs all tasks of an array before it answers, unless RUNS_NOTHING is set. It notes
  // what it is asked in the file `asked`. It answers after WAITS seconds, in the words of ANSWER.
  void write_slurm() {
    write_program("sbatch", R"(echo "sbatch $*" >> "$ASKED"
count=$(grep -c ^sbatch "$ASKED")
if [ "$count" = "${REFUSED:-0}" ]; then echo "sbatch: error: ${WHY:-too many}" >&2; exit 1; fi
tasks=0
for word; do
  case $word in
    --array=*) tasks=${word#--array=1-}; tasks=${tasks%%%*}; shift ;;
    --*) shift ;;
    *) break ;;
  esac
done
sleep "${WAITS:-0}"
echo "a word of the site"
echo "${ANSWER-$((100 + count));cluster}"
if [ -n "$RUNS_NOTHING" ]; then exit; fi
exec >> "$ASKED.out" 2>&1
if [ "$tasks" = 0 ]; then bash "$@"; fi
for i in $(seq "$tasks"); do
  SLURM_ARRAY_JOB_ID=$((100 + count)) SLURM_ARRAY_TASK_ID=$i bash "$@"
done
true
)");
    write_program("scancel", "echo \"scancel $*\" >> \"$ASKED\"\n");
    write_program("squeue",
                  "echo \"squeue $*\" >> \"$ASKED\"\necho \"$QUEUED\"\nexit ${SQUEUE_CODE:-0}\n");
    write_program("sacctmgr", "echo \"$MAX_SUBMIT\"\n");
    write_program("scontrol",
                  "echo \"MaxArraySize            = ${MAX_ARRAY:-1001}\"\n"
                  "echo \"SchedulerParameters     = $SCHEDULER\"\n");
  }
  Words slurm(Words environment = {}) const {
    environment.push_back("ASKED=" + (temp_ / "asked").string());
    return environment;
  }
  std::string asked() const { return read_text(temp_ / "asked"); }
  std::string all_output() const { return read_text(temp_ / "asked.out"); }

 private:
  TempFolder temp_;
};

}  // namespace lsos::test
