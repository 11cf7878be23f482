#include "interchange/clock_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>
#include <vector>

#include "base/quantity.h"
#include "base/text.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr double hour_s = 3600, minute_s = 60, day_s = 86400;
constexpr int most_days = 10000;  // as of the longest duration that plans have

std::optional<int> digits(std::string_view text) {
  int value = 0;
  if (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) == 0) return {};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

// "2026-07-03" of "2026-07-03" or "2026/7/3"; absent for other texts.
std::optional<std::string> date_of(std::string_view text) {
  const char separator = text.find('/') == std::string_view::npos ? '-' : '/';
  std::vector<std::string_view> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(separator, from), text.size());
    parts.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  if (parts.size() != 3 || parts[0].size() != 4) return {};
  const auto year = digits(parts[0]), month = digits(parts[1]), day = digits(parts[2]);
  if (!year || !month || !day) return {};
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return {};
  return fmt::format("{:04}-{:02}-{:02}", *year, *month, *day);
}

// "08:00:00", with a fraction where there is one.
std::string clock_text(double clock_s) {
  const int whole_s = static_cast<int>(clock_s), whole_min = whole_s / 60;
  std::string text = fmt::format("{:02}:{:02}:{:02}", whole_min / 60, whole_min % 60, whole_s % 60);
  if (whole_s != clock_s) text += fmt::format("{:.6f}", clock_s - whole_s).substr(1);
  return text;
}

// The text without a leading "day" or "d".
std::string_view without_day(std::string_view text) {
  for (const std::string_view word : {std::string_view("day"), std::string_view("d")}) {
    if (text.size() < word.size()) continue;
    const bool begins = std::ranges::equal(text.substr(0, word.size()), word, {}, [](char c) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    if (begins) return trimmed(text.substr(word.size()));
  }
  return text;
}

}  // namespace

bool is_range(std::string_view text) {
  std::string_view words = trimmed(text);
  // "2026-07-01 08:00-10:00": what follows a T is written as ISO 8601 does, with its zone.
  const std::size_t blank = words.find(' ');
  if (blank != std::string_view::npos && date_of(words.substr(0, blank))) {
    words = trimmed(words.substr(blank));
  }
  for (const std::string_view sign :
       {"-", "+", "\xe2\x80\x93", "\xe2\x80\x94", " to ", " until "}) {
    const std::size_t at = words.find(sign);
    if (at == std::string_view::npos || !clock_s(trimmed(words.substr(0, at)))) continue;
    const std::string_view end = trimmed(words.substr(at + sign.size()));
    if (!end.empty() && std::isdigit(static_cast<unsigned char>(end[0])) != 0) return true;
  }
  return false;
}

Parsed<std::string> date_of_day(std::string_view text, Instant mission_start) {
  std::string_view words = trimmed(text);
  if (auto date = date_of(words.substr(0, words.find_first_of(" T")))) return {*date, {}};
  words = without_day(words);
  if (words.ends_with(".0")) words.remove_suffix(2);
  const std::optional<int> day = digits(words);
  if (!day || *day < 1 || *day > most_days) {
    return {{},
            fmt::format("{} is no day; 1, 2, ... is allowed, day 1 being the date on which the "
                        "mission starts, or a date such as 2026-07-03",
                        quoted(std::string(text)))};
  }
  using namespace std::chrono;
  const std::string start = format_utc(mission_start);
  const sys_days first = year(*digits(start.substr(0, 4))) /
                         month(static_cast<unsigned>(*digits(start.substr(5, 2)))) /
                         std::chrono::day(static_cast<unsigned>(*digits(start.substr(8, 2))));
  const year_month_day date{first + days(*day - 1)};
  return {fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                      static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day())),
          {}};
}

std::optional<DayClock> day_clock(Instant instant, Instant mission_start) {
  const auto date_in = [](const std::string& utc) {
    using namespace std::chrono;
    return sys_days(year(*digits(utc.substr(0, 4))) /
                    month(static_cast<unsigned>(*digits(utc.substr(5, 2)))) /
                    std::chrono::day(static_cast<unsigned>(*digits(utc.substr(8, 2)))));
  };
  const std::string utc = format_utc(instant);  // "2026-07-03T08:00:00.000Z"
  DayClock found;
  found.day = 1 + static_cast<int>((date_in(utc) - date_in(format_utc(mission_start))).count());
  if (found.day < 1 || found.day > most_days) return {};
  found.clock = utc.substr(11, 12);
  while (found.clock.back() == '0') found.clock.pop_back();
  if (found.clock.back() == '.') found.clock.pop_back();
  if (found.clock.size() == 8 && found.clock.ends_with(":00")) found.clock.resize(5);
  const Parsed<std::string> read = utc_text(found.clock, {utc.substr(0, 10), {}});
  const Parsed<Instant> again = read ? parse_utc(*read.value) : Parsed<Instant>{};
  if (!again || *again.value != instant) return {};
  return found;
}

std::optional<double> clock_s(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return {};
  std::string_view rest = text.substr(colon + 1);
  const std::size_t second_colon = rest.find(':');
  const auto hours = digits(text.substr(0, colon)), minutes = digits(rest.substr(0, second_colon));
  double seconds = 0;
  if (second_colon != std::string_view::npos) {
    rest = rest.substr(second_colon + 1);
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), seconds);
    if (error != std::errc() || end != rest.data() + rest.size()) return {};
    if (!(seconds >= 0 && seconds < minute_s)) return {};
  }
  if (!hours || !minutes || *minutes >= minute_s) return {};
  return *hours * hour_s + *minutes * minute_s + seconds;
}

Parsed<std::string> utc_text(std::string_view text, const TimeContext& context) {
  const std::string_view words = trimmed(text);
  if (words.starts_with('+')) {
    const std::string_view span = trimmed(words.substr(1));
    std::optional<double> after_s = clock_s(span);
    if (!after_s) {
      Parsed<double> parsed = parse_quantity(span, *find_unit("s"));
      if (!parsed || *parsed.value < 0) {
        return {{},
                fmt::format("{}: a time after the last start above is written '+2 h', '+30 min' or "
                            "'+0:30'",
                            quoted(std::string(words)))};
      }
      const bool has_unit = span.find_first_not_of("0123456789.+eE") != std::string_view::npos;
      if (!has_unit && *parsed.value != 0) {
        return {{},
                fmt::format("{} has no unit; '+{} h' or '+{} min' is wanted",
                            quoted(std::string(words)), span, span)};
      }
      after_s = parsed.value;
    }
    if (!context.before) {
      return {{},
              fmt::format("{}: no row above, of the same rover, says a start to count from",
                          quoted(std::string(words)))};
    }
    return {format_utc(*context.before + from_seconds(*after_s)), {}};
  }
  if (is_range(words)) {
    return {{},
            fmt::format("{} is a range, or a clock with a zone; the start alone is wanted, in UTC, "
                        "such as 08:00 (a zone may follow a date and time: "
                        "2026-07-01T08:00-05:00)",
                        quoted(std::string(words)))};
  }
  const bool has_zone = words.ends_with('Z') || words.ends_with('z');  // "08:00Z"
  if (const auto clock = clock_s(trimmed(words.substr(0, words.size() - (has_zone ? 1 : 0))))) {
    if (*clock >= day_s) {
      return {{},
              fmt::format("{}: a clock time is from 00:00 to 23:59; the next day has a Day of "
                          "its own",
                          quoted(std::string(words)))};
    }
    if (context.date.empty()) {
      return {{},
              fmt::format("{}: a clock time needs a Day, in its row or one above, and a "
                          "MissionInfo with StartTime",
                          quoted(std::string(words)))};
    }
    return {fmt::format("{}T{}Z", context.date, clock_text(*clock)), {}};
  }
  const std::size_t blank = words.find_first_of(" T");
  if (const auto date = date_of(words.substr(0, blank))) {
    const std::string_view clock =
        blank == std::string_view::npos ? std::string_view("00:00") : words.substr(blank + 1);
    return {*date + "T" + std::string(trimmed(clock)), {}};
  }
  return {std::string(words), {}};
}

}  // namespace lsos
