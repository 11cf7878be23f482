#include "base/iso_duration.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "base/text.h"

namespace lsos {

namespace {

// One part of an ISO 8601 duration: its letter, its length, and whether it stands after 'T'.
struct DurationPart {
  char letter;
  double length_s;
  bool is_time;
};
constexpr std::array duration_parts{
    DurationPart{'W', 7 * 86400.0, false},
    DurationPart{'D', 86400, false},
    DurationPart{'H', 3600, true},
    DurationPart{'M', 60, true},
    DurationPart{'S', 1, true},
};

}  // namespace

Parsed<double> parse_iso_duration(std::string_view text) {
  const std::string refusal = fmt::format(
      "'{}' is no ISO 8601 duration; weeks, days, hours, minutes and seconds in this order are "
      "allowed, such as 'P2DT3H' or 'PT1H30M'",
      text);
  std::string_view rest = text.substr(1);
  double total_s = 0;
  std::size_t next_part = 0;
  bool is_time = false;
  bool has_fraction = false;
  bool has_part = false;  // since 'P', or since 'T'
  while (!rest.empty()) {
    if (rest.front() == 'T' && !is_time) {
      is_time = true;
      has_part = false;
      rest.remove_prefix(1);
      continue;
    }
    if (has_fraction || !is_digit(rest.front())) return {{}, refusal};
    std::string number;
    while (!rest.empty() &&
           (is_digit(rest.front()) || rest.front() == '.' || rest.front() == ',')) {
      number += rest.front() == ',' ? '.' : rest.front();
      rest.remove_prefix(1);
    }
    has_fraction = number.find('.') != std::string::npos;
    double value = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value,
                                              std::chars_format::fixed);
    if (error != std::errc{} || end != number.data() + number.size() || rest.empty()) {
      return {{}, refusal};
    }
    while (next_part < duration_parts.size() && (duration_parts[next_part].letter != rest.front() ||
                                                 duration_parts[next_part].is_time != is_time)) {
      ++next_part;
    }
    if (next_part == duration_parts.size()) return {{}, refusal};
    total_s += value * duration_parts[next_part].length_s;
    ++next_part;
    has_part = true;
    rest.remove_prefix(1);
  }
  if (!has_part || !std::isfinite(total_s)) return {{}, refusal};
  return {total_s, {}};
}

}  // namespace lsos
