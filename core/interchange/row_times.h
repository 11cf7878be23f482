// Days and times of rows: what a row says, and what it takes over from those above.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "interchange/clock_text.h"
#include "interchange/notes.h"
#include "interchange/row_types.h"
#include "plan/declaration.h"
#include "planet/utc.h"

namespace lsos {

// Start of the mission from which days count.
struct SheetStart {
  std::optional<Instant> instant;
  bool is_said = false;  // also where it cannot be read, which the plan's reader tells
};

// Reads the times of rows in their order. Faults that only follow from another are not told.
class RowTimes {
 public:
  RowTimes(SheetStart mission, Notes& notes, Faults& faults)
      : mission_(mission), notes_(notes), faults_(faults) {}

  // Begins a row that is no event: it has no day.
  void begin(const TypedRow& row);
  // Begins an event of a rover, with its Day or that of the row above.
  void begin_event(const TypedRow& row, const std::string& rover_id);
  // Whether the sheet says a Day, and the date "2026-07-03" on which clock times are.
  bool has_day() const { return has_day_; }
  const std::string& date() const { return date_; }

  // A time of the row as a plan writes it; where it has a fault, which is told, that of a start is
  // absent, and others have a stand-in. The start of an event is to be read before its other times,
  // which count from it.
  std::optional<std::string> time(const FieldDeclaration& field, const std::string& text);

  // Ends an event: reports a Day or start that contradicts another cell. Returns the StartTime of
  // one that says none and is the first of a rover on a new day: it does not begin before that.
  std::optional<std::string> end_event();

 private:
  // What the rows of one rover say before a row.
  struct Before {
    std::optional<Instant> start;
    bool is_start_unread = false;  // the last one above has a fault
    std::string date;              // on which the last one is
    std::string said_date;         // that one of them says, in this cell
    Place day_cell;
    std::optional<std::int64_t> sequence;
  };

  void read_day(const std::string& day, std::string& date_above);
  bool is_mission_unread() const { return !mission_.instant && mission_.is_said; }
  void note_other_days(const std::string& text);
  void check_order();
  void check_day();

  SheetStart mission_;
  Notes& notes_;
  Faults& faults_;
  std::map<const Table*, std::string> date_above_;
  std::map<std::string, Before> before_of_;                  // by rover id
  std::set<std::pair<const Table*, std::string>> reported_;  // columns of which a fault was told
  // The row that is being read.
  const TypedRow* row_ = nullptr;
  Before* before_ = nullptr;  // nullptr: no event
  std::string rover_id_, date_;
  bool has_day_ = false, says_day_ = false, has_start_ = false;
  std::optional<Instant> start_;
};

}  // namespace lsos
