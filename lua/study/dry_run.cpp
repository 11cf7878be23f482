#include "lua/study/dry_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/console.h"
#include "base/error.h"
#include "base/stop_signal.h"
#include "lua/app/progress.h"
#include "lua/app/run_to_end.h"
#include "lua/study/case_run.h"
#include "lua/study/pool.h"
#include "product/study/case_record.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string draw_text(const Draw::Value& value) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  return fmt::format("{:.6g}", std::get<double>(value));
}

struct CheckedCase {
  std::int64_t number = 0;
  std::vector<Draw> draws;
  std::vector<Fault> faults;  // errors of its plan
};

CheckedCase checked(const StudyFiles& files, const Sampler& sampler, std::int64_t number) {
  CheckedCase checked{number, draws_of_case(files, sampler, number), {}};
  const PlanSource source = plan_of_case(files, checked.draws, files.plan_folder());
  const MissionFiles mission = read_mission(source, files.base.catalog);
  for (const Fault& fault : mission.faults.sorted()) {
    if (fault.severity == Severity::error) checked.faults.push_back(fault);
  }
  return checked;
}

Json checked_json(const CheckedCase& checked) {
  Json values = Json::object();
  for (const Draw& drawn : checked.draws) {
    for (const auto& [name, value] : drawn.values) {
      std::visit([&, &key = name](const auto& each) { values[key] = each; }, value);
    }
  }
  Json faults = Json::array();
  for (const Fault& fault : checked.faults) faults.push_back(fault.what);
  return {{"case", checked.number}, {"values", values}, {"faults", faults}};
}

void print_case(const CheckedCase& checked) {
  std::string line = fmt::format("case {}:", checked.number);
  for (const Draw& drawn : checked.draws) {
    for (const auto& [name, value] : drawn.values) {
      line += fmt::format(" {} = {};", name, draw_text(value));
    }
  }
  if (line.back() == ';') line.pop_back();
  print_result("{}\n", line);
  for (const Fault& fault : checked.faults) print_result("  fault: {}\n", fault.what);
}

// Wall time of one case, run in a process and a folder that are gone afterwards; NaN where it could
// not be run.
double measured_s(const StudyFiles& files, std::int64_t number) {
  const fs::path folder =
      fs::temp_directory_path() / fmt::format("lsos-host-{}-{}", files.study.name, getpid());
  fs::create_directories(folder / "cases");
  const auto begin = std::chrono::steady_clock::now();
  bool is_done = false;
  Pool pool(1, [&](std::int64_t one) {
    catch_stop_signals();
    return static_cast<int>(run_case(files, one, folder.string(), 1));
  });
  const int signal = pool.run(
      {number}, [&](std::int64_t, const auto& ending) { is_done = ending.is_success(); }, [] {});
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  if (signal != 0 || !is_done) return std::nan("");
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int dry_run(const StudyFiles& files, const std::vector<std::int64_t>& numbers, std::size_t jobs,
            const SweepOptions& options) {
  const Sampler sampler = files.sampler();
  Json cases = Json::array();
  std::optional<std::int64_t> sound;
  bool has_faults = false;
  for (const std::int64_t number : numbers) {
    const CheckedCase one = checked(files, sampler, number);
    if (options.is_json) {
      cases.push_back(checked_json(one));
    } else {
      print_case(one);
    }
    has_faults |= !one.faults.empty();
    if (one.faults.empty() && !sound) sound = number;
  }
  const double case_s = sound ? measured_s(files, *sound) : std::nan("");
  const double all_s = case_s * static_cast<double>(numbers.size()) /
                       static_cast<double>(std::min(jobs, numbers.size()));
  if (options.is_json) {
    // The library writes NaN as null.
    const Json answer{
        {"cases", cases}, {"jobs", jobs}, {"case_wall_s", case_s}, {"estimate_wall_s", all_s}};
    print_result("{}\n", answer.dump(2, ' ', false, Json::error_handler_t::replace));
  } else if (std::isfinite(case_s)) {
    print_result("case {} took {:.1f} s; {} cases, {} at a time, would take about {}\n", *sound,
                 case_s, numbers.size(), jobs, clock_text(all_s));
  }
  return has_faults ? 2 : 0;
}

}  // namespace lsos
