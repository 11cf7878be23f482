#include "lua/study/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "base/console.h"
#include "base/error.h"
#include "lua/app/run_to_end.h"
#include "lua/study/case_run.h"
#include "lua/study/pool.h"
#include "lua/study/study_files.h"
#include "product/study/case_record.h"
#include "product/study/gather.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

std::vector<std::int64_t> all_cases(const StudyFiles& files) {
  std::vector<std::int64_t> numbers;
  for (std::int64_t number = 1; number <= files.cases; ++number) numbers.push_back(number);
  return numbers;
}

int gather_study(const StudyFiles& files, const std::string& folder) {
  GatherRequest request{folder, std::string(files.base.plan.mission.planet->crs), all_cases(files),
                        {}};
  for (const PlanRover& rover : files.base.plan.rovers) request.rovers.push_back(rover.id);
  const Gathered gathered = gather(request);
  print_result("{} of {} cases in {}/study.gpkg\n", gathered.cases,
               gathered.cases + gathered.missing, folder);
  return 0;
}

}  // namespace

int sweep(const SweepOptions& options) {
  const StudyFiles files = read_study(options.study);
  const std::string folder =
      options.folder.empty() ? "out/" + files.study.name : options.folder;
  if (options.verb == "gather") return gather_study(files, folder);
  fs::create_directories(folder + "/cases");
  std::vector<std::int64_t> numbers = all_cases(files);
  std::erase_if(numbers, [&](std::int64_t number) { return is_done(folder, number); });
  const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
  const auto jobs = options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : processors;
  const int threads = std::max(1, static_cast<int>(processors / jobs));
  std::size_t failed = 0;
  Pool pool(jobs, [&](std::int64_t number) {
    catch_stop_signals();
    return static_cast<int>(run_case(files, number, folder, threads));
  });
  const int signal = pool.run(
      numbers,
      [&](std::int64_t, const ChildProcess::Ending& ending) { failed += ending.is_success() ? 0 : 1; },
      [] {});
  if (signal != 0) return 128 + signal;
  gather_study(files, folder);
  return failed == 0 ? 0 : 1;
}

}  // namespace lsos
