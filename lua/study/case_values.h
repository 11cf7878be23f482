// What is taken from the log of a case that has ended: its series, and the gathered values.
#pragma once

#include <string>
#include <vector>

#include "lua/study/study_files.h"
#include "product/study/case_record.h"

namespace lsos {

struct CaseValues {
  CaseRecord::Values gathered;  // absent values are left out
  std::vector<CaseRecord::Event> events;
  std::string series;  // the bytes of the file
};

// `summary`: the text of summary.json. Throws InputError, and std::runtime_error where a condition
// cannot be evaluated.
CaseValues values_of_case(const StudyFiles& files, const std::string& folder,
                          const std::string& summary);

}  // namespace lsos
