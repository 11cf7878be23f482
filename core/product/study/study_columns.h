// The columns of a study's table of cases, each with what it means.
#pragma once

#include <string>
#include <vector>

#include "product/study/case_record.h"
#include "record/columns.h"

namespace lsos {

struct StudyColumn {
  enum class Kind { parameter, summary, gathered, machine };
  std::string name;
  Kind kind = Kind::summary;
  std::string address;  // of a parameter in the plan; of others "" or where it is taken from
  std::string unit;     // SI, "" for none
  std::string sentence;
  ColumnType type = ColumnType::real;
};
const char* to_string(StudyColumn::Kind kind);

// All columns in their order. `parameters`, `gathered`: those of the study.
std::vector<StudyColumn> study_columns(const std::vector<StudyColumn>& parameters,
                                       const std::vector<StudyColumn>& gathered,
                                       const std::vector<std::string>& rovers);

// The row of a case. `summary`: the text of its summary.json, "" where it has none.
std::vector<ColumnValue> row_of_case(const std::vector<StudyColumn>& columns,
                                     const CaseRecord& record, const std::string& summary,
                                     const std::vector<std::string>& rovers);

}  // namespace lsos
