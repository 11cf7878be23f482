// Studies on a real Slurm of one node, and by a real GNU parallel.
#include <gmock/gmock.h>

#include <csignal>
#include <fstream>
#include <sstream>

#include "system/cluster_folder.h"
#include "system/own_slurm.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;

class RealSlurm : public ClusterFolder {
 protected:
  static constexpr int minutes = 60;

  void SetUp() override {
    ClusterFolder::SetUp();
    if (!OwnSlurm::is_installed()) {
      GTEST_SKIP() << "Slurm is not installed: script/bootstrap long";
    }
    slurm_ = std::make_unique<OwnSlurm>(3);
    ASSERT_TRUE(slurm_->is_up()) << slurm_->logs();
  }

  json send(Words words = {}) {
    words.insert(words.begin(), {"--slurm", "--json", "--chunk", "1", "-o", "sent"});
    const Outcome sent = sweep(words, {slurm_->environment()});
    EXPECT_EQ(sent.exit_code, 0) << sent.err;
    return sent.exit_code == 0 ? json::parse(sent.out) : json();
  }

  void update(const std::string& job, Words changes) {
    changes.insert(changes.begin(), {"scontrol", "update", "JobId=" + job});
    slurm_->ask(changes);
  }
  bool comes_to(const std::string& state, const std::string& job) {
    return comes_true([&] { return slurm_->state_of(job) == state; }, 5 * minutes);
  }

  // Waits until a job is over and returns its last state.
  std::string end_of(const std::string& job) {
    EXPECT_TRUE(comes_true(
        [&] {
          const std::string state = slurm_->state_of(job);
          return state != "PENDING" && state != "RUNNING" && state != "COMPLETING";
        },
        15 * minutes))
        << job << ": " << slurm_->ask({"scontrol", "show", "job", job}) << slurm_->logs();
    return slurm_->state_of(job);
  }

  // The process that runs a case of the study in `sent`; 0: none does.
  pid_t pool_of(int number) const {
    const std::string cases = "--cases" + std::string(1, '\0') + std::to_string(number);
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::ifstream file(entry.path() / "cmdline");
      std::stringstream text;
      text << file.rdbuf();
      std::string words = text.str();
      const bool is_here = words.find((folder() / "sent").string()) != std::string::npos;
      if (is_here && words.ends_with(cases + '\0')) return std::stoi(entry.path().filename());
    }
    return 0;
  }
  // Whether the process of a case has worked so long that its rover drives.
  bool is_driving(int number) const {
    const std::string pool = std::to_string(pool_of(number));
    std::ifstream children("/proc/" + pool + "/task/" + pool + "/children");
    std::string child, word;
    if (!(children >> child)) return false;
    std::ifstream stat("/proc/" + child + "/stat");
    // The 14th number is its time in hundredths of a second; no word of the second has a blank.
    for (int i = 0; i < 14; ++i) stat >> word;
    return stat && std::stol(word) > 200;
  }
  json status() {
    return json::parse(
        run({"sweep", "status", "my study.lua", "-o", "sent", "--json"}, here()).out);
  }

  std::unique_ptr<OwnSlurm> slurm_;
};

// Three long cases: the time of one is over twice, the task of one crashes, one is left alone. Then
// what is missing is sent again.
TEST_F(RealSlurm, runs_stops_and_goes_on_with_a_study) {
  write_long_study("0.5, 1.9, 2");
  const json sent = send();
  ASSERT_EQ(sent["arrays"].size(), 2u) << "2 tasks of an array at most";
  const std::string first = sent["arrays"][0], gathering = sent["gather"];
  ASSERT_TRUE(comes_true([&] { return is_driving(1) && is_driving(2); }, 5 * minutes))
      << slurm_->logs();
  EXPECT_GE(status()["running"].size(), 1u);
  EXPECT_EQ(slurm_->state_of(gathering), "PENDING");
  const Outcome twice = sweep({"--slurm", "-o", "sent"}, {slurm_->environment()});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_THAT(twice.err, HasSubstr("of this study still wait or run: 'scancel "));

  // Slurm itself says that the time is nearly over.
  const std::string stopped = first + "_1", crashed = first + "_2";
  update(stopped, {"TimeLimit=2"});
  ASSERT_GT(pool_of(2), 0);
  kill(pool_of(2), SIGKILL);
  EXPECT_EQ(end_of(crashed), "FAILED");
  ASSERT_TRUE(comes_to("PENDING", stopped)) << slurm_->logs();
  const json part = json::parse(read_text(folder() / "sent/cases/000001.part/summary.json"));
  EXPECT_EQ(part["status"], "incomplete");
  EXPECT_GT(part["sim_s"], 0) << "it has stopped at a checkpoint";
  EXPECT_EQ(slurm_->state_of(gathering), "PENDING");
  // A job that went back waits for two minutes by itself; its node refuses it in the first seconds.
  update(stopped, {"StartTime=now+15"});
  ASSERT_TRUE(comes_to("RUNNING", stopped)) << slurm_->logs();
  ASSERT_TRUE(comes_to("PENDING", stopped)) << slurm_->logs();
  const json later = json::parse(read_text(folder() / "sent/cases/000001.part/summary.json"));
  EXPECT_GT(later["sim_s"], part["sim_s"]) << "it has gone on from there";
  update(stopped, {"TimeLimit=UNLIMITED", "StartTime=now+15"});
  EXPECT_EQ(end_of(stopped), "COMPLETED");
  EXPECT_EQ(end_of(gathering), "COMPLETED");
  EXPECT_EQ(all_rows(folder() / "sent", "cases").size(), 2u) << "what there is, was gathered";

  const json again = send();
  EXPECT_EQ(again["cases"], 1) << "the one that crashed";
  EXPECT_EQ(end_of(again["gather"]), "COMPLETED");
  ASSERT_EQ(sweep({"-j", "2", "-o", "alone"}).exit_code, 0);
  EXPECT_EQ(equal_parts(folder() / "sent"), equal_parts(folder() / "alone"));
}

// A task that its user ends stops, too, but does not go back into the queue.
TEST_F(RealSlurm, ends_what_is_cancelled) {
  write_long_study("0.4");
  const json sent = send();
  const std::string task = sent["arrays"][0].get<std::string>() + "_1";
  ASSERT_TRUE(comes_true([&] { return is_driving(1); }, 5 * minutes)) << slurm_->logs();
  slurm_->ask({"scancel", task});
  EXPECT_EQ(end_of(task), "CANCELLED");
  const json part = json::parse(read_text(folder() / "sent/cases/000001.part/summary.json"));
  EXPECT_GT(part["sim_s"], 0) << "it has stopped at a checkpoint";
  EXPECT_EQ(end_of(sent["gather"]), "COMPLETED") << "of no case";
}

TEST_F(RealSlurm, goes_on_after_another_job_took_its_place) {
  write_long_study("1.9");
  const json sent = send({"-j", "2"});
  const std::string task = sent["arrays"][0].get<std::string>() + "_1";
  ASSERT_TRUE(comes_true([&] { return is_driving(1); }, 5 * minutes)) << slurm_->logs();
  slurm_->ask({"sbatch", "--partition=urgent", "--cpus-per-task=2", "--output=/dev/null",
               "--wrap=sleep 1"});
  ASSERT_TRUE(comes_to("PENDING", task)) << slurm_->logs();
  const json part = json::parse(read_text(folder() / "sent/cases/000001.part/summary.json"));
  EXPECT_GT(part["sim_s"], 0) << "it has stopped at a checkpoint";
  update(task, {"StartTime=now+15"});
  EXPECT_EQ(end_of(task), "COMPLETED");
  EXPECT_EQ(end_of(sent["gather"]), "COMPLETED");
}

// As somebody does who has only the printed script.
TEST_F(RealSlurm, takes_the_printed_script) {
  const Outcome script =
      sweep({"--print", "slurm", "--chunk", "1", "--limit", "1", "-o", "sent", "--time", "1:30:00",
             "--partition", "main", "-j", "2", "--directive=--comment=\"a study\""},
            {slurm_->environment()});
  write("job.sh", script.out);
  std::string commands = "set -e\n";
  std::istringstream lines(script.out);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#   ")) commands += line.substr(4) + "\n";
  }
  const Outcome sent = run_command({"bash", "-c", commands}, here({slurm_->environment()}));
  ASSERT_EQ(sent.exit_code, 0) << commands << sent.err;
  ASSERT_THAT(sent.out, HasSubstr("Submitted batch job "));
  std::string last = sent.out.substr(sent.out.rfind(' ') + 1);
  last.pop_back();
  const std::string job = slurm_->ask({"scontrol", "show", "job", last});
  for (const char* part : {"TimeLimit=01:30:00", "Partition=main", "CPUs/Task=2", "Requeue=1",
                           "JobName=my_study", "Comment=a study"}) {
    EXPECT_THAT(job, HasSubstr(part));
  }
  EXPECT_EQ(end_of(last), "COMPLETED");
  ASSERT_EQ(sweep({"-j", "1", "-o", "alone"}).exit_code, 0);
  EXPECT_EQ(equal_parts(folder() / "sent"), equal_parts(folder() / "alone"));
}

class OtherEngine : public ClusterFolder {
 protected:
  OtherEngine() { odd += "\\x"; }

  void TearDown() override {
    ASSERT_EQ(sweep({"-j", "1", "-o", "alone"}).exit_code, 0);
    EXPECT_EQ(equal_parts(folder() / "out/my study"), equal_parts(folder() / "alone"));
  }

  // Runs the script of an engine for both of its tasks and to gather, with what it sets for these.
  void run_tasks(const std::string& engine, const std::vector<std::string>& variables) {
    const std::string script = printed(engine, {"--chunk", "2", "--time", "10"});
    for (const std::string& variable : variables) {
      const Outcome outcome = run_command({"bash", script}, here({variable}));
      EXPECT_EQ(outcome.exit_code, 0) << variable << ": " << outcome.err;
    }
  }
};

TEST_F(OtherEngine, pbs_runs_the_printed_script) {
  run_tasks("pbs", {"PBS_ARRAY_INDEX=1", "PBS_ARRAYID=2", "PBS_ARRAY_INDEX=3", "OTHER=1"});
}

TEST_F(OtherEngine, grid_engine_runs_the_printed_script) {
  run_tasks("sge", {"SGE_TASK_ID=2", "SGE_TASK_ID=1", "SGE_TASK_ID=undefined"});
}

// A task that stops itself before its time is over goes on where it is put back.
TEST_F(OtherEngine, tasks_go_on_after_their_time) {
  write_long_study("2");
  std::string script = read_text(printed("sge", {"--time", "10"}));
  const std::string whole = "(timeout --preserve-status 480)";
  const std::size_t at = script.find(whole);
  ASSERT_NE(at, std::string::npos);
  const auto run_script = [&](const std::string& text, const std::string& variable) {
    return run_command({"bash", "-c", text}, here({variable}));
  };
  const std::string part =
      std::string(script).replace(at, whole.size(), "(timeout --preserve-status 5)");
  const Outcome stopped = run_script(part, "SGE_TASK_ID=1");
  ASSERT_EQ(stopped.exit_code, 99) << "back into the queue: " << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("stopped: the same command goes on"));
  EXPECT_EQ(run_script(script, "SGE_TASK_ID=1").exit_code, 0);
  EXPECT_EQ(run_script(script, "OTHER=1").exit_code, 0);
}

// What HTCondor reads in a line "NAME = VALUE" of a submit file, with its macros.
std::string submitted(const std::string& file, const std::string& name, const std::string& task) {
  std::istringstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(name + " ")) continue;
    std::string value = line.substr(line.find("= ") + 2);
    for (const auto& [macro, text] :
         {std::pair{"$(task)", task.c_str()}, std::pair{"$(DOLLAR)", "$"}}) {
      for (std::size_t at; (at = value.find(macro)) != std::string::npos;) {
        value.replace(at, std::string(macro).size(), text);
      }
    }
    return value;
  }
  return "";
}

// Words in HTCondor's double quotes, as `man condor_submit` has them under "arguments": blanks are
// between them, but not within single quotes, and a quote that is twice is one.
Words quoted_words(const std::string& value) {
  Words words;
  bool is_quoted = false, is_in_word = false;
  for (std::size_t i = 1; i + 1 < value.size(); ++i) {
    const char c = value[i];
    if (!is_in_word && c != ' ') words.emplace_back();
    is_in_word = is_quoted || c != ' ';
    const bool is_double = (c == '"' || (is_quoted && c == '\'')) && value[i + 1] == c;
    if (is_double) ++i;
    if (c == '\'' && !is_double) {
      is_quoted = !is_quoted;
    } else if (is_in_word) {
      words.back() += c;
    }
  }
  return words;
}

// HTCondor is not at hand: the test reads the file as it does.
TEST_F(OtherEngine, condor_runs_the_printed_file) {
  const std::string file = read_text(printed("condor", {"--chunk", "2", "--limit", "3"}));
  EXPECT_EQ(submitted(file, "max_materialize", ""), "3");
  EXPECT_THAT(file, HasSubstr("\nqueue task from (\n1-2\n3-4\n)\n"));
  EXPECT_EQ(submitted(file, "initialdir", ""), folder());
  EXPECT_THAT(quoted_words(submitted(file, "environment", "")),
              ::testing::Contains("LSOS_PATH=a b:it's"));
  for (const char* task : {"3-4", "1-2"}) {
    Words words = quoted_words(submitted(file, "arguments", task));
    words.insert(words.begin(), submitted(file, "executable", task));
    const Outcome outcome = run_command(words, here());
    EXPECT_EQ(outcome.exit_code, 0) << task << ": " << outcome.err;
  }
  const std::size_t at = file.find("#   cd ");
  ASSERT_NE(at, std::string::npos);
  const std::string gathering = file.substr(at + 4, file.find('\n', at) - at - 4);
  EXPECT_EQ(run_command({"sh", "-c", gathering}).exit_code, 0) << "from any folder: " << gathering;
}

TEST_F(OtherEngine, parallel_runs_the_printed_script) {
  if (run_command({"parallel", "--version"}).out.find("GNU parallel") == std::string::npos) {
    sweep({});  // what is compared at the end
    GTEST_SKIP() << "GNU parallel is not installed: script/bootstrap long";
  }
  const Outcome outcome =
      run_command({"bash", printed("parallel", {"--chunk", "2", "--limit", "2"})}, here());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace lsos::test
