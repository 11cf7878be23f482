#include "base/moment_text.h"

#include <fmt/format.h>

namespace lsos {

std::string moment_text(SimTime time) {
  constexpr long long day_s = 86'400;
  const auto whole_s = static_cast<long long>(seconds(time));
  std::string text = fmt::format("{} s", seconds(time));
  if (whole_s < day_s) return text;
  const long long in_day_s = whole_s % day_s;
  return fmt::format("{} (day {}, {:02}:{:02}:{:02})", text, whole_s / day_s + 1, in_day_s / 3600,
                     in_day_s / 60 % 60, in_day_s % 60);
}

}  // namespace lsos
