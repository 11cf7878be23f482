#include "lua/study/study_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "base/resolved_path.h"
#include "base/sha256.h"
#include "edit/editable_file.h"
#include "lua/api/api.h"
#include "lua/host/run_values.h"
#include "lua/runtime/loader.h"
#include "lua/runtime/reader.h"
#include "lua/runtime/state.h"
#include "lua/study/base_number.h"
#include "lua/study/gathering_check.h"
#include "plan/kmz_archive.h"
#include "study/case_plan.h"
#include "study/stop_rule.h"

namespace lsos {

namespace {

namespace fs = std::filesystem;

constexpr const char* study_kind = "study";

// The study that the script makes; its name is the file's.
Study load_study(const std::string& file, const std::string& source) {
  Script script;
  script.name = fs::path(file).stem().string();
  script.file = file;
  script.folder = fs::path(file).parent_path().string();
  script.source = source;
  LuaState lua(make_api);
  Faults faults;
  Study study;
  lua.run([&](lua_State* L) {
    if (const ConstructedValue* made = load_script(L, script, study_kind, faults)) {
      study = std::any_cast<Study>(made->value);
    }
  });
  faults.throw_if_errors();
  study.file = file;
  study.name = script.name;
  return study;
}

// The document in which the values of cases are put.
std::string document_of(const MissionFiles& base) {
  if (!is_zip(base.plan_bytes)) return base.plan_bytes;
  return EditableFile(base.plan_bytes, base.plan.file).kml();
}

std::vector<Dimension> dimensions_of(const std::vector<Parameter>& parameters) {
  std::vector<Dimension> all;
  for (const Parameter& parameter : parameters) {
    for (Dimension& dimension : parameter.dimensions()) all.push_back(std::move(dimension));
  }
  return all;
}

// Number of cases; 0 and a fault where the sampling does not fit what varies.
std::int64_t count_cases(const StudyFiles& files, Faults& faults) {
  const Study& study = files.study;
  const std::vector<Dimension> dimensions = dimensions_of(files.parameters);
  if (study.sampling == Sampling::sobol && dimensions.size() > sobol_dimensions_max) {
    faults.error(study.place, fmt::format("study: sampling = 'sobol': {} dimensions at most, "
                                          "found {}",
                                          sobol_dimensions_max, dimensions.size()));
  }
  if (study.sampling != Sampling::grid) return study.cases.value_or(0);
  bool is_grid = true;
  for (const Parameter& parameter : files.parameters) {
    if (!parameter.choices.empty()) continue;
    is_grid = false;
    faults.error(parameter.variation.place,
                 fmt::format("vary '{}': '{}' has no values to make a grid of: a list or range "
                             "has, and other samplings need none",
                             parameter.variation.of, to_string(parameter.variation.form)));
  }
  if (!is_grid) return 0;
  const std::int64_t size = grid_size(dimensions);
  if (size > cases_max) {
    faults.error(study.place,
                 fmt::format("study: the grid has more than {} cases; a 'random' or 'sobol' "
                             "sampling takes some of them",
                             cases_max));
    return 0;
  }
  if (study.cases && *study.cases > size) {
    faults.error(study.place,
                 fmt::format("study: cases = {}: the grid has {}", *study.cases, size));
    return 0;
  }
  return study.cases.value_or(size);
}

// About 200 times in the time that the plan says, so that bands look smooth; a round number.
double interval_of(const StudyFiles& files) {
  if (files.study.interval_s > 0) return files.study.interval_s;
  constexpr double wanted = 200, day_s = 86400, open_ended_s = 366 * day_s, of_open_ended_s = 300;
  const MissionInfo& mission = files.base.plan.mission;
  double all_s = seconds(mission.max_duration);
  // A MaxDuration that the plan does not say leaves a day, or a year where conditions end events.
  if (!mission.has_max_duration && all_s > day_s && all_s < open_ended_s) all_s -= day_s;
  const bool is_open = !mission.has_max_duration && all_s >= open_ended_s;
  const double least_s = is_open ? of_open_ended_s : all_s / wanted;
  for (const double round_s : {1.0, 2.0, 5.0, 10.0, 20.0, 30.0, 60.0, 120.0, 300.0, 600.0, 900.0,
                               1800.0, 3600.0, 7200.0, 10800.0, 21600.0, 43200.0}) {
    if (round_s >= least_s) return round_s;
  }
  return 86400;
}

// The first, last and, of a short list, all values that a parameter can have.
std::vector<Draw> extremes_of(const Parameter& parameter) {
  constexpr std::size_t all_max = 20;
  constexpr double first = 0, last = 1 - 0x1.0p-53;
  std::vector<double> shares{first, last};
  const std::size_t count = parameter.choices.size();
  if (parameter.variation.form == Form::list && count <= all_max) {
    shares.clear();
    for (std::size_t i = 0; i < count; ++i) {
      shares.push_back((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    }
  }
  std::vector<Draw> extremes;
  for (const double share : shares) {
    extremes.push_back(draw(parameter, {{parameter.name(), share}}));
  }
  return extremes;
}

void note_use(const MissionFiles& mission, StudyFiles& files) {
  files.scripts.merge(script_digests(mission));
  files.terrains.insert({mission.terrain.name, mission.terrain});
}

// Reads the plan with each extreme value, one at a time: scripts may refuse what a field allows.
void check_extremes(StudyFiles& files, Faults& faults) {
  for (const Parameter& parameter : files.parameters) {
    if (parameter.is_place()) continue;  // whether there is ground, each case finds
    for (const Draw& extreme : extremes_of(parameter)) {
      const PlanSource source = plan_of_case(files, {extreme}, files.plan_folder());
      const MissionFiles mission = read_mission(source, files.base.catalog);
      note_use(mission, files);
      for (const Fault& fault : mission.faults.sorted()) {
        if (fault.severity != Severity::error) continue;
        faults.error(
            parameter.variation.place,
            fmt::format("vary '{}' = {}: {}", parameter.variation.of, extreme.text, fault.what));
      }
    }
  }
}

}  // namespace

std::string StudyFiles::plan_folder() const {
  const std::string folder = fs::path(plan_file).parent_path().string();
  return folder.empty() ? "." : folder;
}

Sampler StudyFiles::sampler() const {
  return {study.sampling, study.seed, cases, dimensions_of(parameters)};
}

StudyFiles read_study(const std::string& file) {
  const std::optional<std::string> source = read_file(file);
  if (!source) throw InputError({file, 0}, "cannot be read");
  StudyFiles files;
  files.study = load_study(file, *source);
  files.sha256 = sha256_hex(*source);
  files.plan_file = resolved_path(fs::path(file).parent_path().string(), files.study.plan);
  files.base = read_mission(files.plan_file);
  files.base.faults.throw_if_errors();
  files.kml = document_of(files.base);
  const Declarations& declarations = files.base.catalog->declarations();
  Faults faults;
  const BaseNumbers numbers(files.base, files.kml);
  const ParameterContext context{files.base.plan, declarations,
                                 [&](const Address& address) { return numbers.of(address); },
                                 [](const std::string& key) { return find_unit(si_unit_of(key)); }};
  files.parameters = parameters_of(files.study, context, faults);
  if (!faults.has_errors()) files.cases = count_cases(files, faults);
  check_gatherings(files.base, files.study, faults);
  check_stop_rule(files.study, faults);
  note_use(files.base, files);
  check_extremes(files, faults);
  faults.throw_if_errors();
  files.interval_s = interval_of(files);
  return files;
}

std::vector<Draw> draws_of_case(const StudyFiles& files, const Sampler& sampler,
                                std::int64_t number) {
  return draws(files.parameters, sampler.shares(number));
}

PlanSource plan_of_case(const StudyFiles& files, const std::vector<Draw>& draws,
                        const std::string& folder) {
  const fs::path home = fs::weakly_canonical(fs::absolute(files.base.plan.home)),
                 from = fs::weakly_canonical(fs::absolute(folder));
  const CaseOrigin origin{home.lexically_relative(from).string(),
                          sha256_hex(read_file(home.string()).value_or(""))};
  const std::string text =
      case_plan(files.kml, files.base.plan, files.base.catalog->declarations(), draws, origin);
  const std::string file = folder + "/plan.kml";
  return {file, parse_kml(text, file), "", text, true};
}

}  // namespace lsos
