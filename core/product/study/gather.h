// What the cases of a study have left, gathered into one GeoPackage, study.gpkg: layers `cases` (a
// row a case), `bands`, `arrivals`, `ends` (where missions ended that did not complete) and
// `columns` (what the columns of `cases` mean). It needs no logs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "product/study/bands.h"
#include "product/study/study_columns.h"

namespace lsos {

struct GatherRequest {
  std::string folder;                // of the study
  std::string crs;                   // of the body, as in Body
  std::int64_t cases = 0;            // numbers 1 to this
  std::vector<std::string> rovers;   // their ids
  std::vector<PlannedEvent> events;  // of the study's plan
  std::vector<StudyColumn> parameters, gathered;
};

struct Gathered {
  std::size_t cases = 0;      // rows of layer `cases`
  std::size_t completed = 0;  // missions
  std::size_t not_run = 0;    // that could not be run
  std::size_t missing = 0;    // that have not run yet
};

inline constexpr const char* study_table = "study.gpkg";

// Throws OutputError, and InputError where a case's files are damaged.
Gathered gather(const GatherRequest& request);

}  // namespace lsos
