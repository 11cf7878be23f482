// Chooses the notes of a log that a map or a page shows: a script may write thousands a second.
#pragma once

#include <cstddef>
#include <vector>

#include "record/log.h"

namespace lsos {

// Greatest number of notes that are shown; the log has all.
inline constexpr std::size_t shown_notes_max = 2000;
// Fields of a note that are longer than this many bytes are not shown, and of its name the first.
inline constexpr std::size_t shown_note_bytes_max = 4096, shown_note_name_bytes_max = 200;

// Chooses `limit` of `count` items, evenly spread, as they come.
struct EvenChoice {
  std::size_t count = 0, limit = 0;
  std::size_t passed = 0;

  bool takes_next();
};

struct ThinnedNotes {
  std::vector<NoteRow> rows;  // in order of the log
  std::size_t in_log = 0;
};

// Notes of the same rover and name form a kind. Kinds with few notes are kept whole; the others
// keep the same number each, spread evenly, including the first and the last.
ThinnedNotes thinned_notes(const LogReader& log, std::size_t most = shown_notes_max);

// The number of notes kept of each kind: the greatest limit at which all kinds together are at most
// `most`. `counts`: notes of each kind.
std::size_t limit_of_each(std::vector<std::size_t> counts, std::size_t most);

}  // namespace lsos
