#include "edit/shifted_time.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <regex>

#include "base/error.h"
#include "base/quantity.h"
#include "planet/utc.h"

namespace lsos {

namespace {

// "+02:00", "+0200", "+02"; 0 for "Z" and "".
SimTime offset_of(const std::string& zone) {
  if (zone.empty() || zone == "Z") return {};
  const int hours = std::atoi(zone.substr(1, 2).c_str());
  const int minutes = std::atoi(zone.substr(zone[zone.size() - 3] == ':' ? 4 : 3).c_str());
  const SimTime offset = std::chrono::minutes(60 * hours + (zone.size() > 3 ? minutes : 0));
  return zone.front() == '-' ? -offset : offset;
}

}  // namespace

std::string shifted_utc(const std::string& utc, SimTime by) {
  const Parsed<Instant> instant = parse_utc(utc);
  LSOS_ASSERT(instant);
  const Instant shifted = *instant.value + by;
  static const std::regex form(
      R"(\d{4}-\d\d-\d\d(?:([T ])\d\d:\d\d(:\d\d(\.\d{1,3})?)?(Z|[+-]\d\d(:?\d\d)?)?)?)");
  std::smatch parts;
  if (!std::regex_match(utc, parts, form)) return format_utc(shifted);
  const std::string zone = parts[4];
  // "2026-07-02T08:00:00.000" by the clock of its zone.
  std::string text = format_utc(shifted + offset_of(zone));
  text.pop_back();
  // What was not written is left out while it is zero.
  constexpr std::size_t to_date = 10, to_minutes = 16, to_seconds = 19;
  const std::size_t written = !parts[1].matched   ? to_date
                              : !parts[2].matched ? to_minutes
                                                  : to_seconds + parts[3].length();
  std::size_t kept = text.size();
  for (const std::size_t length :
       {to_seconds + 3, to_seconds + 2, to_seconds, to_minutes, to_date}) {
    const bool is_zero = text.find_first_not_of("T0:.", length) == std::string::npos;
    if (length >= written && is_zero) kept = length;
  }
  text.resize(std::max(kept, written));
  if (text.size() > to_date && parts[1].matched) text[to_date] = *parts[1].first;
  if (text.size() > to_date) text += parts[1].matched ? zone : "Z";
  const Parsed<Instant> again = parse_utc(text);
  return again && *again.value == shifted ? text : format_utc(shifted);
}

std::string shifted_duration(std::string_view duration, SimTime by) {
  const Parsed<double> length_s = parse_quantity(duration, *find_unit("s"));
  LSOS_ASSERT(length_s);
  return fmt::format("{} s", *length_s.value + seconds(by));
}

}  // namespace lsos
