#include "planet/utc.h"

#include <erfa.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "base/parsed.h"

namespace lsos {

namespace {

using std::chrono::sys_days;

constexpr std::int64_t second_us = 1'000'000;
constexpr std::int64_t day_us = 86'400 * second_us;
constexpr sys_days epoch = std::chrono::year{2000} / 1 / 1;
constexpr int first_year = 1960;
constexpr int last_year = 2100;

// TAI - UTC, us, at that share of a UTC day. ERFA's table ends with the newest leap second known
// when the package was made; later moments get its last value, so a leap second announced since
// needs a newer ERFA. Whole seconds since 1972; before that UTC drifted, and the result is rounded.
std::int64_t tai_minus_utc_us(sys_days day, double day_share) {
  const std::chrono::year_month_day date{day};
  double delta_s = 0;
  const int status =
      eraDat(static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
             static_cast<int>(static_cast<unsigned>(date.day())), day_share, &delta_s);
  LSOS_ASSERT(status >= 0);  // 1: after the table, see above
  return std::llround(delta_s * 1e6);
}

std::int64_t tai_minus_utc_at_us(sys_days day, std::int64_t of_day_us) {
  const std::int64_t within = std::clamp<std::int64_t>(of_day_us, 0, day_us);
  return tai_minus_utc_us(day, static_cast<double>(within) / static_cast<double>(day_us));
}

// Length of a UTC day; longer than day_us when it ends with a leap second.
std::int64_t length_us(sys_days day) {
  return day_us + tai_minus_utc_us(day + std::chrono::days{1}, 0.0) - tai_minus_utc_us(day, 1.0);
}

Instant instant(sys_days day, std::int64_t of_day_us) {
  return {(day - epoch).count() * day_us + of_day_us + tai_minus_utc_at_us(day, of_day_us)};
}

struct UtcLabel {
  sys_days day;
  std::int64_t of_day_us;  // 0..length of that day
};

UtcLabel utc_label(Instant instant) {
  // UTC is behind TAI by less than a day, so the label lies on this day or the one before.
  sys_days day =
      epoch + std::chrono::floor<std::chrono::days>(std::chrono::microseconds{instant.tai_us});
  for (;; day -= std::chrono::days{1}) {
    const std::int64_t since_midnight_tai_us = instant.tai_us - (day - epoch).count() * day_us;
    // The offset depends on the label in the drifting years; two rounds settle it.
    std::int64_t of_day_us = since_midnight_tai_us;
    for (int round = 0; round < 2; ++round) {
      of_day_us = since_midnight_tai_us - tai_minus_utc_at_us(day, of_day_us);
    }
    if (of_day_us >= 0) return {day, of_day_us};
  }
}

// Reads a moment from the front of a text, piece by piece.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  bool is_at_end() const { return rest_.empty(); }
  bool next_is_digit() const { return !rest_.empty() && rest_[0] >= '0' && rest_[0] <= '9'; }

  // Takes one of the characters if it comes next; 0 when none does.
  char take(std::string_view any_of) {
    if (rest_.empty() || any_of.find(rest_[0]) == std::string_view::npos) return 0;
    const char found = rest_[0];
    rest_.remove_prefix(1);
    return found;
  }
  void skip_blanks() {
    while (take(" \t\r\n")) {
    }
  }
  // How many digits come next.
  std::size_t digits() const {
    const std::size_t end = rest_.find_first_not_of("0123456789");
    return std::min(end, rest_.size());
  }
  // Takes the word if it comes next.
  bool take_word(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  // Exactly that many digits.
  std::optional<int> number(std::size_t digits) {
    if (rest_.size() < digits) return {};
    int value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + digits, value);
    if (error != std::errc{} || end != rest_.data() + digits || rest_[0] == '-') return {};
    rest_.remove_prefix(digits);
    return value;
  }
  // Digits after a decimal point, to the nearest microsecond.
  std::int64_t fraction_us() {
    double value = 0;
    for (double weight = 0.1; next_is_digit(); weight /= 10) {
      value += weight * (rest_[0] - '0');
      rest_.remove_prefix(1);
    }
    return std::llround(value * 1e6);
  }

 private:
  std::string_view rest_;
};

struct Fields {
  int year = 0, month = 0, day = 0;
  std::optional<int> day_of_year;  // in place of month and day
  int hour = 0, minute = 0, second = 0;
  std::int64_t fraction_us = 0;
  std::int64_t zone_us = 0;  // local time - UTC
};

// read_zone() and read_time() return why a text is not in the shape of a moment, else "".
std::string read_zone(Reader& in, Fields& out) {
  in.skip_blanks();
  if (in.is_at_end() || in.take("Zz") || in.take_word("UTC")) return "";
  const char sign = in.take("+-");
  if (!sign) return "after the time only a zone such as 'Z' or '+02:00' is allowed";
  const auto hours = in.number(2);
  const bool has_minutes = in.take(":") || in.next_is_digit();
  const auto minutes = has_minutes ? in.number(2) : std::optional<int>(0);
  if (!hours || !minutes) return "a zone is written as '+02:00'";
  if (*hours > 14 || *minutes > 59) return "zones from -14:00 to +14:00 are allowed";
  const int size_min = *hours * 60 + *minutes;
  out.zone_us = 60 * second_us * (sign == '-' ? -size_min : size_min);
  return "";
}

// "12:00", "12:00:00.5"; in the basic format "1200", "120000.5".
std::string read_time(Reader& in, Fields& out) {
  const bool is_basic = in.digits() == 4 || in.digits() == 6;
  const auto hour = in.number(2);
  const bool has_minute = hour && (is_basic || in.take(":"));
  const auto minute = has_minute ? in.number(2) : std::nullopt;
  if (!minute) return "a time of day is written as '12:00' or '12:00:00.5'";
  out.hour = *hour;
  out.minute = *minute;
  if (is_basic ? in.next_is_digit() : in.take(":") != 0) {
    const auto second = in.number(2);
    if (!second) return "seconds are written with two digits, as in '12:00:05'";
    out.second = *second;
    if (in.take(".,")) {
      if (!in.next_is_digit()) return "digits must follow the decimal point of the seconds";
      out.fraction_us = in.fraction_us();
    }
  }
  return read_zone(in, out);
}

// "2026-07-01" and the day of the year, "2026-182"; in the basic format "20260701", "2026182".
bool read_date(Reader& in, Fields& out) {
  const bool is_basic = in.digits() == 8 || in.digits() == 7;
  const auto year = in.number(4);
  if (!year || (!is_basic && !in.take("-"))) return false;
  out.year = *year;
  if (in.digits() == 3) {
    out.day_of_year = in.number(3);
    return true;
  }
  const auto month = in.number(2);
  const bool has_day = month && (is_basic || in.take("-"));
  const auto day = has_day ? in.number(2) : std::nullopt;
  if (!day) return false;
  out.month = *month;
  out.day = *day;
  return true;
}

std::string read_fields(std::string_view text, Fields& out) {
  Reader in(text);
  in.skip_blanks();
  if (!read_date(in, out)) {
    return "ISO 8601 is allowed, such as '2026-07-01T12:00:00Z', or with the day of the year "
           "'2026-182T12:00:00Z'";
  }
  const bool separated = in.take("Tt ");
  in.skip_blanks();
  if (in.is_at_end()) return "";  // a date alone is its midnight
  if (!separated) return "'T' or a space must stand between date and time";
  std::string why = read_time(in, out);
  if (!why.empty()) return why;
  in.skip_blanks();
  return in.is_at_end() ? "" : "nothing may follow the zone";
}

// Sets month and day from the day of the year; returns an error where the year has no such day.
std::string find_day_of_year(Fields& in) {
  const auto year = std::chrono::year{in.year};
  const int last = year.is_leap() ? 366 : 365;
  const int number = *in.day_of_year;
  if (number < 1 || number > last) {
    return fmt::format("day {} of the year {}: 1..{} is allowed", number, in.year, last);
  }
  const sys_days day = sys_days{year / 1 / 1} + std::chrono::days{number - 1};
  const std::chrono::year_month_day date{day};
  in.month = static_cast<int>(static_cast<unsigned>(date.month()));
  in.day = static_cast<int>(static_cast<unsigned>(date.day()));
  return "";
}

std::string range_fault(const Fields& in) {
  const auto outside = [](const char* name, int value, int low, int high) {
    return value >= low && value <= high
               ? std::string()
               : fmt::format("{} {}: {}..{} is allowed", name, value, low, high);
  };
  for (std::string why :
       {outside("year", in.year, first_year, last_year), outside("month", in.month, 1, 12),
        outside("hour", in.hour, 0, 23), outside("minute", in.minute, 0, 59)}) {
    if (!why.empty()) return why;
  }
  const auto month = std::chrono::year{in.year} / in.month;
  const std::chrono::year_month_day last = month / std::chrono::last;
  return outside("day", in.day, 1, static_cast<int>(static_cast<unsigned>(last.day())));
}

Parsed<Instant> refused(std::string_view text, std::string_view why) {
  return {{}, fmt::format("'{}' is no UTC time: {}", text, why)};
}

}  // namespace

Parsed<Instant> parse_utc(std::string_view text) {
  Fields in;
  std::string why = read_fields(text, in);
  if (why.empty() && in.day_of_year) why = find_day_of_year(in);
  if (why.empty()) why = range_fault(in);
  if (!why.empty()) return refused(text, why);

  // Second 60 is reached as one second after second 59, which is found in UTC first: a leap
  // second ends a UTC day, whatever the local clock shows.
  const std::int64_t leap_us = in.second == 60 ? second_us : 0;
  const std::int64_t clock_us = ((in.hour * 60 + in.minute) * 60 + in.second) * second_us - leap_us;
  const sys_days local_day = std::chrono::year{in.year} / in.month / in.day;
  const std::int64_t utc_us = clock_us - in.zone_us;
  const auto days = std::chrono::floor<std::chrono::days>(std::chrono::microseconds{utc_us});
  const sys_days day = local_day + days;
  const std::int64_t of_day_us = utc_us - days.count() * day_us + leap_us;

  const bool in_leap_second =
      leap_us > 0 && of_day_us + in.fraction_us < length_us(day) && of_day_us >= day_us;
  if (in.second > 59 && !in_leap_second) {
    return refused(
        text, fmt::format("second {}: 0..59 is allowed, and 60 in a leap second only", in.second));
  }
  Instant result = instant(day, of_day_us);
  result.tai_us += in.fraction_us;
  return {result, ""};
}

double utc_days(Instant instant) {
  const UtcLabel label = utc_label(instant);
  const auto of_day_us = static_cast<double>(std::min(label.of_day_us, day_us));
  return static_cast<double>((label.day - epoch).count()) + of_day_us / static_cast<double>(day_us);
}

std::string format_utc(Instant instant) {
  const UtcLabel label = utc_label(instant + SimTime{500});
  const std::chrono::year_month_day date{label.day};
  const std::int64_t ms = label.of_day_us / 1000;
  // A leap second is minute 59, second 60.
  const std::int64_t minute = std::min<std::int64_t>(ms / 60'000, 24 * 60 - 1);
  const std::int64_t minute_ms = ms - minute * 60'000;
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     minute / 60, minute % 60, minute_ms / 1000, minute_ms % 1000);
}

}  // namespace lsos
