#include "lua/study/study_products.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/console.h"
#include "base/error.h"
#include "base/files.h"
#include "base/output_error.h"
#include "lua/study/gather_request.h"
#include "lua/study/stop_early.h"
#include "mission/model/site.h"

namespace lsos {

namespace {

// A grid of which some combinations have no case: values of parameters then depend on each other.
bool is_part_of_grid(const StudyFiles& files) {
  if (files.study.sampling != Sampling::grid) return false;
  std::vector<Dimension> dimensions;
  for (const Parameter& parameter : files.parameters) {
    for (Dimension& dimension : parameter.dimensions()) dimensions.push_back(std::move(dimension));
  }
  return files.cases != grid_size(dimensions);
}

void add_study_ground(const StudyFiles& files, StudyPageRequest& request) {
  const Plan& plan = files.base.plan;
  try {
    request.ground =
        ground_at(files.base.terrain, *plan.mission.planet, site_of(plan), plan.mission.seed);
  } catch (const InputError& error) {
    request.left_out.push_back(fmt::format("the relief: {}", error.what()));
  }
}

// Writes a product that may fail; results are worth having without it.
template <class Make>
void write_product(const std::string& file, Make make) {
  try {
    write_file(file, make());
  } catch (const OutputError&) {
    throw;
  } catch (const std::exception& error) {
    print_message("warning: {}: {}; 'lsos-host sweep gather' makes it again\n", file, error.what());
  }
}

}  // namespace

StudyPageRequest study_page_request(const StudyFiles& files, const std::string& folder,
                                    bool has_ground) {
  StudyPageRequest request;
  request.folder = folder;
  request.name = files.study.name;
  request.doc = files.study.doc;
  request.sampling = to_string(files.study.sampling);
  request.seed = files.study.seed;
  request.cases = files.cases;
  request.is_independent = !is_part_of_grid(files);
  request.has_one_start = std::ranges::none_of(files.parameters, [](const Parameter& parameter) {
    return parameter.name() == "MissionInfo.StartTime";
  });
  request.plan = files.base.plan;
  if (has_ground) add_study_ground(files, request);
  return request;
}

Gathered write_study(const StudyFiles& files, const std::string& folder, int threads) {
  StopWatch enough(files, folder);
  GatherRequest of_cases = gather_request(files, folder);
  of_cases.cases = enough.last_case().value_or(files.cases);
  const Gathered gathered = gather(of_cases);
  StudyPageRequest request = study_page_request(files, folder, true);
  request.cases = of_cases.cases;
  request.stopped = enough.text();
  request.threads = threads;
  write_product(folder + "/" + study_page_file, [&] { return study_page(request); });
  write_product(folder + "/" + study_overlay_file, [&] { return study_overlay(request); });
  return gathered;
}

}  // namespace lsos
