#include "product/thinned_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/utf8.h"

namespace lsos {

namespace {

// The text, or its first bytes and dots.
std::string shortened(const std::string& text, std::size_t bytes_max) {
  return text.size() <= bytes_max ? text : beginning(text, bytes_max) + "...";
}

}  // namespace

bool EvenChoice::takes_next() {
  const std::size_t k = passed++;
  if (limit >= count || k == 0) return limit > 0;
  if (limit == 1) return false;
  const auto step = [&](std::size_t i) { return i * (limit - 1) / (count - 1); };
  return step(k) > step(k - 1);
}

std::size_t limit_of_each(std::vector<std::size_t> counts, std::size_t most) {
  std::ranges::sort(counts);
  std::size_t left = most;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::size_t share = left / (counts.size() - k);
    if (counts[k] > share) return share;
    left -= counts[k];
  }
  return most;
}

ThinnedNotes thinned_notes(const LogReader& log, std::size_t most) {
  const LogReader::NoteCounts kinds = log.note_counts(most);
  ThinnedNotes notes;
  notes.in_log = kinds.in_all;
  std::map<LogReader::NoteKind, EvenChoice> choices;
  std::vector<std::size_t> counts;
  for (const auto& [kind, count] : kinds.by_kind) counts.push_back(count);
  const std::size_t limit = limit_of_each(counts, most);
  for (const auto& [kind, count] : kinds.by_kind) choices[kind] = {count, limit};
  // If there are more kinds than notes that can be shown, all notes are treated as one kind.
  const bool is_one_kind = kinds.by_kind.empty();
  EvenChoice all{kinds.in_all, most};
  log.for_each_note([&](const NoteRow& row) {
    EvenChoice* choice = &all;
    if (!is_one_kind) {
      const auto known = choices.find({row.rover_id, row.name});
      if (known == choices.end()) return;  // in a run that goes on: written after counting
      choice = &known->second;
    }
    if (!choice->takes_next()) return;
    NoteRow& kept = notes.rows.emplace_back(row);
    kept.name = shortened(row.name, shown_note_name_bytes_max);
    if (kept.fields_json.size() > shown_note_bytes_max) {
      kept.fields_json =
          fmt::format("{{\"left_out\":\"{} bytes; log.gpkg has them\"}}", row.fields_json.size());
    }
  });
  return notes;
}

}  // namespace lsos
