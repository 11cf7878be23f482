#include "interchange/sequences.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/quantity.h"
#include "plan/suggestions.h"

namespace lsos {

namespace {

constexpr std::int64_t sequence_step = 10;

struct Numbered {
  const SourcePlacemark* placemark = nullptr;
  SourceField* field = nullptr;
  std::optional<std::int64_t> number;  // that the row says
};

// Numbers the rows from `first` up to `last`, which is the row after them that has a number, or the
// end.
void number_run(std::vector<Numbered>& rows, std::size_t first, std::size_t last,
                const std::string& rover_id, std::int64_t& greatest, Faults& faults) {
  const std::int64_t before = first == 0 ? 0 : rows[first - 1].number.value_or(0);
  const auto count = static_cast<std::int64_t>(last - first);
  std::int64_t step = sequence_step, start = before;
  if (last < rows.size()) {
    const std::int64_t after = *rows[last].number;
    // Rows that are out of order follow the row above.
    const bool is_between = after > before;
    if (is_between && before + count * step >= after) step = (after - before) / (count + 1);
    if (step < 1) {
      const SourceField& field = *rows[first].field;
      faults.error({rows[first].placemark->file, field.line, field.column},
                   fmt::format("Sequence is empty, and there is no whole number between {} and {}, "
                               "which the rows of rover {} above and below have; clear the column "
                               "for this rover, and its rows are 10, 20, 30, ...",
                               before, after, quoted(rover_id)));
      start = greatest;  // numbers that collide with none
      step = 1;
    }
  }
  for (std::size_t i = first; i < last; ++i) {
    start += step;
    rows[i].number = start;
    rows[i].field->text = std::to_string(start);
  }
  greatest = std::max(greatest, start);
}

}  // namespace

void number_events(KmlSource& plan, Faults& faults) {
  std::map<std::string, std::vector<Numbered>> rovers;
  for (SourcePlacemark& placemark : plan.placemarks) {
    auto& fields = placemark.data.front().fields;
    const auto sequence = std::ranges::find(fields, "Sequence", &SourceField::name);
    const auto rover = std::ranges::find(fields, "RoverId", &SourceField::name);
    if (sequence == fields.end()) continue;
    Numbered row{&placemark, &*sequence, {}};
    if (const auto number = parse_integer(sequence->text)) row.number = number.value;
    // A text that is no number is reported when the plan is read.
    if (!row.number && !sequence->text.empty()) continue;
    rovers[rover == fields.end() ? "" : rover->text].push_back(row);
  }
  for (auto& [rover_id, rows] : rovers) {
    std::int64_t greatest = 0;
    for (const Numbered& row : rows) greatest = std::max(greatest, row.number.value_or(0));
    for (std::size_t i = 0; i < rows.size();) {
      std::size_t end = i;
      while (end < rows.size() && !rows[end].number) ++end;
      if (end > i) number_run(rows, i, end, rover_id, greatest, faults);
      i = end + 1;
    }
  }
}

void report_unnumbered(const KmlSource& plan, Faults& faults) {
  std::set<std::string> told;  // files
  for (const SourcePlacemark& placemark : plan.placemarks) {
    for (const SourceField& field : placemark.data.front().fields) {
      if (field.name != "Sequence" || !field.text.empty()) continue;
      // A sheet without the column is told once.
      if (field.column.empty() && !told.insert(placemark.file).second) continue;
      faults.error({placemark.file, field.line, field.column},
                   "Sequence is empty: with --onto it says which event of the plan the row is; a "
                   "new one takes a number that is free, between those that it goes between");
    }
  }
}

}  // namespace lsos
