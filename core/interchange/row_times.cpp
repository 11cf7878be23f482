#include "interchange/row_times.h"

#include <fmt/format.h>

#include "base/quantity.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr const char* start_field = "StartTime";

// "C4" of a sheet, "line 4" of an outline.
std::string cell_name(const Place& place) {
  return fmt::format("{}{}", place.column.empty() ? "line " : place.column, place.line);
}

}  // namespace

void RowTimes::begin(const TypedRow& row) {
  row_ = &row;
  before_ = nullptr;
  date_.clear();
  has_day_ = says_day_ = has_start_ = false;
  start_.reset();
}

void RowTimes::begin_event(const TypedRow& row, const std::string& rover_id) {
  begin(row);
  rover_id_ = rover_id;
  before_ = &before_of_[rover_id];
  std::string& date_above = date_above_[row.table];
  const std::string day = row.text(column::day);
  if (!day.empty()) read_day(day, date_above);
  date_ = date_above;
  if (date_.empty() && mission_.instant) date_ = *date_of_day("1", *mission_.instant).value;
  has_day_ = !date_above.empty();
}

void RowTimes::read_day(const std::string& day, std::string& date_above) {
  if (is_mission_unread()) return;
  if (!mission_.instant) {
    if (!reported_.emplace(row_->table, column::day).second) return;
    faults_.error(row_->cell_place(column::day),
                  fmt::format("Day = {}: days are counted from the StartTime of MissionInfo, "
                              "which is missing",
                              quoted(day)));
    return;
  }
  const Parsed<std::string> date = date_of_day(day, *mission_.instant);
  if (date) {
    date_above = *date.value;
    says_day_ = true;
  } else {
    faults_.error(row_->cell_place(column::day), fmt::format("Day = {}", date.why));
  }
}

std::optional<std::string> RowTimes::time(const FieldDeclaration& field, const std::string& text) {
  const bool is_event = before_ != nullptr, is_start = is_event && field.name == start_field;
  if (is_start) has_start_ = true;
  const bool is_after = text.starts_with('+');
  const std::optional<Instant> counts_from = !is_event ? std::nullopt
                                             : start_  ? start_
                                                       : before_->start;
  TimeContext context = is_event ? TimeContext{date_, counts_from} : TimeContext{};
  // What cannot be read for another fault, which is told, is read with a stand-in.
  const bool is_start_unread = is_event && is_after && before_->is_start_unread && !start_;
  const bool is_day_unread = is_event && clock_s(text) && is_mission_unread();
  if (is_start_unread) context.before = mission_.instant.value_or(Instant{});
  if (is_day_unread) context.date = "2000-01-01";
  Parsed<std::string> time = utc_text(text, context);
  if (time && (is_start_unread || is_day_unread)) {
    before_->is_start_unread |= is_start;
    return is_start ? std::nullopt : time.value;
  }
  const bool takes_first_day = time && is_event && !has_day_ && clock_s(text);
  if (takes_first_day && reported_.emplace(row_->table, column::day).second) {
    faults_.warning(row_->cell_place(field.name),
                    fmt::format("{} = {}: no Day is said, so clock times of this sheet are of day "
                                "1, {}",
                                field.name, text, date_));
  }
  if (time && is_event && has_day_) note_other_days(text);
  const Parsed<Instant> instant = time ? parse_utc(*time.value) : Parsed<Instant>{};
  if (time && !instant) {
    time.why = fmt::format(
        "{} is no time; 08:00, '+2 h', and a date and time such as 2026-07-01 "
        "08:00 are allowed",
        quoted(text));
  }
  if (is_start) {
    start_ = instant.value;
    before_->is_start_unread = !instant;
  }
  if (time.why.empty()) return std::move(time.value);
  faults_.error(row_->cell_place(field.name), fmt::format("{} = {}", field.name, time.why));
  if (is_start) return {};
  return format_utc(mission_.instant.value_or(Instant{}));  // that it is missing would only follow
}

// Tells where a clock time falls on another day of reports, `check` and `edit`.
void RowTimes::note_other_days(const std::string& text) {
  const std::string start_clock = format_utc(*mission_.instant).substr(11, 5);
  const auto clock = clock_s(text), days_begin = clock_s(start_clock);
  if (!clock || !days_begin || *clock >= *days_begin) return;
  notes_.add(
      fmt::format("days are UTC dates here; reports, check and edit count them from {0} "
                  "on, when the mission starts, so that a time before {0} is of the day "
                  "before there",
                  start_clock));
}

std::optional<std::string> RowTimes::end_event() {
  check_order();
  check_day();
  std::optional<std::string> midnight;
  if (has_day_ && date_ != before_->date && !has_start_ && mission_.instant) {
    const Parsed<Instant> begin = parse_utc(date_ + "T00:00:00Z");
    if (begin && *begin.value > *mission_.instant) {
      midnight = date_ + "T00:00:00Z";
      start_ = begin.value;
      before_->is_start_unread = false;
    }
  }
  if (start_) before_->start = start_;
  // A date and time is on no day of the rows above.
  const std::string start = row_->text(start_field);
  const bool is_on_day = says_day_ || !has_start_ || start.starts_with('+') || clock_s(start);
  if (has_day_ && is_on_day) before_->date = date_;
  if (says_day_) {
    before_->said_date = date_;
    before_->day_cell = row_->cell_place(column::day);
  }
  before_->sequence = parse_integer(row_->text("Sequence")).value;
  return midnight;
}

// Rows of a rover follow each other in time, but for those whose numbers say another order.
void RowTimes::check_order() {
  const auto sequence = parse_integer(row_->text("Sequence")).value;
  if (sequence && before_->sequence && *sequence < *before_->sequence) return;
  const bool is_day_before = says_day_ && date_ < before_->said_date;
  if (is_day_before) {
    faults_.error(
        row_->cell_place(column::day),
        fmt::format("Day = {}, {}, is before the Day of a row above of rover {}, {} at {}; "
                    "rows of a rover stand in the order of their times",
                    row_->text(column::day), date_, quoted(rover_id_), before_->said_date,
                    cell_name(before_->day_cell)));
  } else if (start_ && before_->start && *start_ < *before_->start) {
    faults_.warning(
        row_->cell_place(start_field),
        fmt::format("{} is before the start that a row above of rover {} has, {}; is a "
                    "Day wanted?",
                    format_utc(*start_), quoted(rover_id_), format_utc(*before_->start)));
  }
}

// The Day of a row and its start are one date.
void RowTimes::check_day() {
  if (!says_day_ || !start_ || !has_start_) return;
  const std::string date = format_utc(*start_).substr(0, 10);
  if (date == date_) return;
  const std::string day = row_->text(column::day);
  const std::string day_date = day == date_ ? "" : fmt::format(" ({})", date_);
  faults_.error(
      row_->cell_place(start_field),
      fmt::format("{} = {} is {}, but Day = {}{} at {}; one of them is to be changed or emptied",
                  start_field, quoted(row_->text(start_field)), format_utc(*start_), day, day_date,
                  cell_name(row_->cell_place(column::day))));
}

}  // namespace lsos
