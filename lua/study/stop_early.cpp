#include "lua/study/stop_early.h"

#include <fmt/format.h>

#include <cmath>

#include "base/files.h"
#include "product/study/case_record.h"
#include "study/stop_rule.h"

namespace lsos {

namespace {

constexpr std::int64_t step = 10;  // cases between two looks

// The value that the rule asks of a case; NaN where it has none.
double value_of(const StopRule& rule, const CaseRecord& record) {
  if (rule.of == share_completed) return record.status == "completed" ? 1 : 0;
  for (const auto& [name, value] : record.gathered) {
    if (name != rule.of) continue;
    if (const auto* real = std::get_if<double>(&value)) return *real;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  }
  return std::nan("");
}

}  // namespace

std::optional<std::int64_t> StopWatch::last_case() {
  const std::optional<StopRule>& rule = files_.study.stop_when;
  while (rule && !last_ && static_cast<std::int64_t>(values_.size()) < files_.cases) {
    const auto number = static_cast<std::int64_t>(values_.size()) + 1;
    const std::string file = case_folder(folder_, number) + "/" + case_file;
    const auto record = read_case_record(read_file(file).value_or(""));
    if (!record) break;
    values_.push_back(value_of(*rule, *record));
    if (number % step != 0 || number < rule->after) continue;
    const std::optional<double> half = half_width(*rule, values_);
    if (!half || !(*half <= rule->within)) continue;
    last_ = number;
    half_width_ = *half;
  }
  return last_;
}

std::string StopWatch::text() const {
  if (!last_) return "";
  const StopRule& rule = *files_.study.stop_when;
  const std::string what = rule.quantile
                               ? fmt::format("P{:.4g} of {}", 100 * *rule.quantile, rule.of)
                               : "the share of missions that complete";
  return fmt::format("{} is known within {:.3g} (95 %) after {} of {} cases", what, half_width_,
                     *last_, files_.cases);
}

}  // namespace lsos
