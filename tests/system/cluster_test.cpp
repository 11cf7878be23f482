// Studies on a cluster: the scripts that are printed, and what is sent to Slurm.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "system/cluster_folder.h"

namespace lsos::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

using Cluster = ClusterFolder;

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST_F(Cluster, scripts_are_read_by_a_shell) {
  for (const char* engine : {"slurm", "pbs", "sge", "parallel"}) {
    const std::string file = printed(engine, {"--chunk", "2", "--limit", "3"});
    const Outcome checked = run_command({"bash", "-n", file});
    EXPECT_EQ(checked.exit_code, 0) << engine << ": " << checked.err;
    const std::string text = read_text(file);
    EXPECT_THAT(text, HasSubstr(" sweep run '"));
    EXPECT_THAT(text, HasSubstr(" sweep gather '"));
    EXPECT_THAT(text, HasSubstr("\n1-2\n3-4\nTASKS\n"));
    EXPECT_THAT(text, HasSubstr("export LSOS_PATH='a b:it'\\''s'\n")) << "as where it was printed";
    EXPECT_THAT(text, Not(HasSubstr("{{")));
  }
  EXPECT_FALSE(fs::exists(folder() / "out")) << "nothing was written";
}

TEST_F(Cluster, heads_of_scripts_say_what_tasks_are_given) {
  const Words options{"--time",
                      "1:30:00",
                      "--partition",
                      "short",
                      "-j",
                      "4",
                      "--directive=--account=moon",
                      "--directive=--mem=2G"};
  Words pbs_options = options;
  pbs_options.back() = "--directive=-l mem=2gb";
  const std::string slurm = read_text(printed("slurm", options));
  for (const char* line :
       {"#SBATCH --job-name=my_study\n", "#SBATCH --cpus-per-task=4\n", "#SBATCH --time=1:30:00\n",
        "#SBATCH --partition=short\n", "#SBATCH --account=moon\n", "#SBATCH --mem=2G\n",
        "#SBATCH --signal=B:USR1@120\n", " --quiet -j 4 --threads 1 "}) {
    EXPECT_THAT(slurm, HasSubstr(line));
  }
  const std::string pbs = read_text(printed("pbs", pbs_options));
  for (const char* line :
       {"#PBS -N my_study\n", "#PBS -l select=1:ncpus=4\n", "#PBS -l walltime=1:30:00\n",
        "#PBS -q short\n", "#PBS -l mem=2gb\n", "qsub -J 1-2 job.sh", "timeout 5280"}) {
    EXPECT_THAT(pbs, HasSubstr(line));
  }
  const std::string sge = read_text(printed("sge", options));
  for (const char* line :
       {"#$ -l h_rt=5400\n", "timeout --preserve-status 5280", "#$ -pe smp 4\n", "-t 1-1 job.sh"}) {
    EXPECT_THAT(sge, HasSubstr(line));
  }
  EXPECT_THAT(read_text(printed("sge")), Not(HasSubstr("#$ -l"))) << "nor an empty one";
  EXPECT_THAT(slurm, HasSubstr("--dependency=afterany:${job1%%;*} job.sh gather\n"));
  EXPECT_THAT(read_text(printed("sge", {"--limit", "3"})), HasSubstr("-t 1-1 -tc 3 job.sh"));
}

// Torque takes no more.
TEST_F(Cluster, jobs_have_names_of_fifteen_characters_where_that_is_wanted) {
  write("a study of a long name.lua", read_text(folder() / "my study.lua"));
  const auto script = [&](const char* engine) {
    return run({"sweep", "a study of a long name.lua", "--print", engine}, here()).out;
  };
  EXPECT_THAT(script("pbs"), HasSubstr("#PBS -N a_study_of_a_lo\n"));
  EXPECT_THAT(script("slurm"), HasSubstr("#SBATCH --job-name=a_study_of_a_long_name\n"));
}

TEST_F(Cluster, scripts_have_the_names_that_their_user_sees) {
  fs::create_directory_symlink(folder(), temp() / "link");
  const std::string link = temp() / "link";
  const Outcome outcome = sweep({"--print", "slurm", "-o", "../out", "--allow-files", "."},
                                {"PWD=" + link, "LSOS_GPU=software", "LSOS_;date=1"});
  EXPECT_THAT(outcome.out, HasSubstr("\ncd " + link + " || exit\n"));
  EXPECT_THAT(outcome.out, HasSubstr("'" + link + "/my study.lua' -o " + link + "/../out --quiet"));
  EXPECT_THAT(outcome.out, HasSubstr(" --allow-files ."));
  EXPECT_THAT(outcome.out, HasSubstr("\nexport LSOS_GPU=software\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("date"))) << "no name of a variable";
  EXPECT_THAT(sweep({"--print", "slurm"}, {"PWD=/"}).out, Not(HasSubstr("cd / ||")));
}

TEST_F(Cluster, tells_what_has_no_place_in_a_script) {
  const auto refusal = [&](const Words& words) {
    const Outcome outcome = sweep(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    return outcome.err;
  };
  EXPECT_THAT(refusal({"--print", "parallel", "--time", "5"}),
              HasSubstr("--time: a script for parallel has no use for it"));
  EXPECT_THAT(refusal({"--print", "condor", "--partition", "a"}),
              HasSubstr("--partition: a script"));
  EXPECT_THAT(refusal({"--chunk", "5"}), HasSubstr("--chunk is for the tasks of a cluster"));
  EXPECT_THAT(refusal({"--slurm", "--print", "slurm"}), HasSubstr("are both given"));
  EXPECT_THAT(refusal({"--slurm", "--time", "1h"}), HasSubstr("--time 1h: five minutes or more"));
  EXPECT_THAT(refusal({"--slurm", "--time", "4:59"}), HasSubstr("--time 4:59: five minutes"));
  EXPECT_THAT(refusal({"--slurm", "--partition", "a b"}), HasSubstr("--partition a b: a name"));
  EXPECT_THAT(refusal({"--slurm", "--directive=a\nb"}), HasSubstr("one line is wanted"));
  EXPECT_THAT(refusal({"--print", "lsf"}), HasSubstr("--print"));
  EXPECT_THAT(run({"sweep", "gather", "my study.lua", "--slurm"}, here()).err,
              HasSubstr("sweep gather: --slurm and --print are for a whole study"));
  EXPECT_THAT(refusal({"--print", "slurm", "-o", "a\nb"}), HasSubstr("has a line break"));
  EXPECT_THAT(run({"sweep", "my study.lua", "--slurm"},
                  {.folder = folder(), .environment = {"PATH=/nowhere"}})
                  .err,
              HasSubstr("there is no sbatch in PATH"));
  EXPECT_FALSE(fs::exists(folder() / "out"));
}

TEST_F(Cluster, takes_the_template_of_a_site_from_lsos_path) {
  write("site/cluster/slurm.sh", "#!/bin/sh\n{{run}} --cases {{task}}\n");
  const Outcome outcome = sweep({"--print", "slurm", "--chunk", "3"}, {"LSOS_PATH=site"});
  EXPECT_THAT(outcome.out, ::testing::StartsWith("#!/bin/sh\n"));
  EXPECT_THAT(outcome.out, HasSubstr(" --cases 1-3\n"));
  write("site/cluster/slurm.sh", "\n{{rum}}\n");
  EXPECT_THAT(sweep({"--print", "slurm"}, {"LSOS_PATH=site"}).err,
              HasSubstr("site/cluster/slurm.sh:2: {{rum}}: there is no such value; did you mean"));
  // One that came with the study would choose what runs on the cluster.
  write("cluster/slurm.sh", "mine\n");
  EXPECT_THAT(sweep({"--print", "slurm"}).out, HasSubstr("#SBATCH"));
}

TEST_F(Cluster, runs_a_study_as_arrays_that_slurm_takes) {
  write_slurm();
  write_study(3);
  ASSERT_EQ(sweep({"-j", "1", "-o", "alone"}).exit_code, 0);
  const Outcome sent =
      sweep({"--slurm", "--chunk", "1", "-o", "sent", "--json"}, slurm({"MAX_ARRAY=3"}));
  ASSERT_EQ(sent.exit_code, 0) << sent.err;
  EXPECT_EQ(json::parse(sent.out), json::parse(R"({"cases": 3, "tasks": 3,
      "arrays": ["101", "102"], "gather": "103"})"));
  EXPECT_THAT(asked(), HasSubstr("--array=1-2 "));
  EXPECT_THAT(asked(), HasSubstr("--array=1-1 "));
  EXPECT_THAT(asked(), HasSubstr("--dependency=afterany:101:102 "));
  EXPECT_THAT(asked(), HasSubstr("100%% \"odd\"")) << "a % is a pattern in names of output";
  EXPECT_EQ(equal_parts(folder() / "alone"), equal_parts(folder() / "sent")) << all_output();
}

TEST_F(Cluster, sends_again_only_what_is_missing) {
  write_slurm();
  write_study(2);
  ASSERT_EQ(sweep({"--slurm"}, slurm()).exit_code, 0);
  const Outcome nothing = sweep({"--slurm"}, slurm());
  EXPECT_EQ(nothing.exit_code, 0);
  EXPECT_THAT(nothing.err, HasSubstr("no case is missing in out/my study"));
  const Outcome no_jobs = sweep({"--slurm", "--json"}, slurm());
  EXPECT_EQ(json::parse(no_jobs.out), json::parse(R"({"cases": 0, "tasks": 0, "arrays": [],
      "gather": null})"));
  EXPECT_EQ(count_of(asked(), "sbatch"), 2);
  fs::remove_all(folder() / "out/my study/cases/000002");
  EXPECT_THAT(sweep({"--slurm"}, slurm({"QUEUED=101\n7"})).err,
              HasSubstr("job 101 of this study still waits or runs: 'scancel 101' ends it"));
  EXPECT_EQ(count_of(asked(), "sbatch"), 2);
  const Outcome again = sweep({"--slurm"}, slurm());
  EXPECT_THAT(again.out, HasSubstr("1 case is in the queue as 1 task of job 103; job 104"));
  EXPECT_THAT(read_text(folder() / "out/my study/slurm/job.sh"), HasSubstr("\n2\nTASKS\n"));
  EXPECT_EQ(all_rows(folder() / "out/my study", "cases").size(), 2u);
}

TEST_F(Cluster, leaves_nothing_in_the_queue_when_a_job_is_refused) {
  write_slurm();
  const Outcome refused =
      sweep({"--slurm", "--chunk", "1"}, slurm({"MAX_ARRAY=3", "REFUSED=2", "RUNS_NOTHING=1"}));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("sbatch has refused a job: sbatch: error: too many; nothing "
                                     "is in the queue"));
  EXPECT_THAT(asked(), HasSubstr("\nscancel 101\n"));
  write_program("scancel", "exit 1\n");
  const Outcome left =
      sweep({"--slurm", "--chunk", "1", "--limit", "1", "-o", "other"},
            slurm({"MAX_ARRAY=3", "REFUSED=4", "RUNS_NOTHING=1", "WHY=AssocMaxSubmitJobLimit"}));
  EXPECT_THAT(left.err,
              HasSubstr("AssocMaxSubmitJobLimit; what is in the queue already goes by 'scancel "
                        "103'; fewer tasks of more cases: --chunk"));
  EXPECT_THAT(sweep({"--slurm", "-o", "third"}, slurm({"REFUSED=5", "WHY=QOSMaxWallLimit"})).err,
              ::testing::EndsWith("sbatch: error: QOSMaxWallLimit; nothing is in the queue\n"));
}

TEST_F(Cluster, knows_jobs_by_what_sbatch_answers) {
  write_slurm();
  EXPECT_THAT(sweep({"--slurm"}, slurm({"RUNS_NOTHING=1", "ANSWER=Submitted batch job 55"})).out,
              HasSubstr("of job 55; job 55 gathers"));
  const Outcome none =
      sweep({"--slurm", "-o", "other"}, slurm({"RUNS_NOTHING=1", "ANSWER=thank you"}));
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("an answer without its number: 'a word of the site\nthank you'; "
                                  "'squeue --me' shows the job"));
}

TEST_F(Cluster, sends_nothing_where_the_queue_is_not_known) {
  write_slurm();
  ASSERT_EQ(sweep({"--slurm"}, slurm({"RUNS_NOTHING=1"})).exit_code, 0);
  const Outcome down =
      sweep({"--slurm"}, slurm({"SQUEUE_CODE=1", "QUEUED=the controller is down"}));
  EXPECT_EQ(down.exit_code, 2);
  EXPECT_THAT(down.err, HasSubstr("squeue does not say whether jobs 101 102 of this study still "
                                  "wait or run: the controller is down"));
  EXPECT_EQ(count_of(asked(), "sbatch"), 2);
  // The answer to a job that squeue has forgotten.
  const Outcome gone = sweep({"--slurm"}, slurm({"SQUEUE_CODE=1", "RUNS_NOTHING=1",
                                                 "QUEUED=slurm_load_jobs error: Invalid job id "
                                                 "specified"}));
  EXPECT_EQ(gone.exit_code, 0) << gone.err;
}

TEST_F(Cluster, sends_a_study_once_though_two_send_it_at_a_time) {
  write_slurm();
  const Words words = program({"sweep", "my study.lua", "--slurm", "--quiet"});
  const Surroundings where =
      here(slurm({"RUNS_NOTHING=1", "WAITS=0.2", "QUEUED=101\n102\n103\n104"}));
  Process first(words, where), second(words, where);
  const Outcome one = first.wait(), other = second.wait();
  EXPECT_EQ(one.exit_code + other.exit_code, 2) << one.err << other.err;
  EXPECT_THAT(one.err + other.err, HasSubstr("of this study still wait or run"));
  EXPECT_EQ(count_of(asked(), "sbatch"), 2);
}

TEST_F(Cluster, tries_again_those_that_could_not_be_run) {
  write_slurm();
  ASSERT_EQ(sweep({"--slurm"}, slurm({"RUNS_NOTHING=1"})).exit_code, 0);
  const std::string mark = folder() / "out/my study/cases/000002.not_run";
  std::ofstream(mark) << "{}";
  sweep({"--slurm"}, slurm({"RUNS_NOTHING=1"}));
  EXPECT_THAT(read_text(folder() / "out/my study/slurm/job.sh"), HasSubstr("\n1,3-4\nTASKS\n"));
  EXPECT_TRUE(fs::exists(mark));
  sweep({"--slurm", "--retry", "failed"}, slurm({"RUNS_NOTHING=1"}));
  const std::string script = read_text(folder() / "out/my study/slurm/job.sh");
  EXPECT_THAT(script, HasSubstr("\n1-4\nTASKS\n"));
  EXPECT_THAT(script, Not(HasSubstr("--retry"))) << "each time that a task starts";
  EXPECT_FALSE(fs::exists(mark));
}

TEST_F(Cluster, makes_arrays_of_no_more_tasks_than_the_site_allows) {
  write_slurm();
  const Outcome sent =
      sweep({"--slurm", "--chunk", "1", "--json"},
            slurm({"RUNS_NOTHING=1", "SCHEDULER=bf_interval=30,max_array_tasks=2,defer"}));
  EXPECT_EQ(json::parse(sent.out)["arrays"].size(), 2u) << "4 tasks";
  EXPECT_THAT(asked(), HasSubstr("--array=1-2 "));
}

TEST_F(Cluster, gives_tasks_more_cases_where_there_may_not_be_so_many) {
  write_slurm();
  const Outcome sent = sweep({"--slurm", "--chunk", "1"},
                             slurm({"MAX_SUBMIT=\n4\n9", "QUEUED=7", "RUNS_NOTHING=1"}));
  EXPECT_THAT(sent.err,
              HasSubstr("tasks have 2 cases in place of 1, as this user may send 3 more"));
  EXPECT_THAT(sent.out, HasSubstr("4 cases are in the queue as 2 tasks of job 101"));
  EXPECT_THAT(
      sweep({"--slurm", "-o", "other"}, slurm({"MAX_SUBMIT=2", "QUEUED=7", "RUNS_NOTHING=1"})).err,
      HasSubstr("this user may send 1 more jobs (MaxSubmitJobs), and 2 at least"));
  const Outcome printed = sweep({"--print", "slurm", "--chunk", "1"},
                                slurm({"MAX_SUBMIT=3", "QUEUED=1\n2\nslurm: a warning\n3"}));
  EXPECT_THAT(printed.err, HasSubstr("have 4 cases in place of 1, as this user may send 0 more"));
}

}  // namespace
}  // namespace lsos::test
