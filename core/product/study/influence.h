// Which parameter of a study moves which result.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "product/study/study_results.h"
#include "study/first_order.h"
#include "study/rank_correlation.h"

namespace lsos {

// One number a case, that a study is looked at by.
struct StudyNumber {
  std::string name;
  std::optional<std::size_t> column;  // of StudyResults; none: whether the mission completed
  std::string unit, sentence;
  std::vector<double> values;  // by case; NaN where a case has none
};

// Whether missions completed (1 or 0), what was gathered, and the numbers of the summary, as far as
// they vary. Cases that could not be run have none of them.
std::vector<StudyNumber> study_numbers(const StudyResults& results);
// Name of the first.
inline constexpr const char* completed_number = "completed";

struct InfluenceCell {
  std::optional<RankCorrelation> correlation;  // none of a parameter whose values are texts
  bool is_found = false;                       // it is more than chance, see `false_rate`
  std::optional<FirstOrderShare> share;
  bool is_share_found = false;
};

// At most this share of what is marked as found is expected to be chance.
inline constexpr double false_rate = 0.05;

struct Influence {
  std::vector<std::size_t> parameters;            // columns of StudyResults that vary
  std::vector<std::vector<InfluenceCell>> cells;  // by number, then by parameter
};

// `has_shares`: parameters were drawn independently of each other.
Influence influence(const StudyResults& results, const std::vector<StudyNumber>& numbers,
                    bool has_shares);

}  // namespace lsos
