// study.html: the results of a study on one page that works offline.
#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "plan/plan.h"
#include "product/study/study_results.h"
#include "terrain/ground.h"

namespace lsos {

// What a page shows besides the study's table and its cases' files.
struct StudyPageRequest {
  std::string folder;  // of the study, with its study.gpkg
  std::string name, doc;
  std::string sampling;  // as in the study: "latin_hypercube"
  std::uint64_t seed = 0;
  std::int64_t cases = 0;      // that there are to be
  bool is_independent = true;  // parameters are drawn independently: not of a part of a grid
  bool has_one_start = true;   // missions of all cases start at the same time
  Plan plan;                   // of the study
  std::shared_ptr<const Ground> ground = nullptr;  // none: without relief
  std::string stopped = {};                        // why there are no more cases; "": there are all
  std::vector<std::string> left_out = {};          // parts missing from the page, and why
  int threads = 2;
};

inline constexpr const char* study_page_file = "study.html";

// Cases that the page has in its table and as single courses; its numbers are of all.
inline constexpr std::size_t study_page_cases_max = 5000;

// Throws InputError where files of the study are missing or damaged.
std::string study_page(const StudyPageRequest& request);
nlohmann::ordered_json study_document(const StudyPageRequest& request);

// The site frame of the study's maps.
SiteFrame study_site(const StudyPageRequest& request);

}  // namespace lsos
