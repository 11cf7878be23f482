// Which of a log's notes a map or a page shows: a script may write thousands a second.
#pragma once

#include <cstddef>
#include <vector>

#include "record/log.h"

namespace lsos {

// Notes of a log that are shown at most; the log has them all.
inline constexpr std::size_t shown_notes_max = 2000;
// Fields of a note that are longer than this many bytes are left out of what is shown.
inline constexpr std::size_t shown_note_bytes_max = 4096;

struct ThinnedNotes {
  std::vector<NoteRow> rows;  // in order of the log
  std::size_t in_log = 0;
};

// Notes of one rover and name are a kind. Kinds with few notes are kept whole, of the others each
// keeps as many as any other, spread evenly over its notes, with its first and its last.
ThinnedNotes thinned_notes(const LogReader& log, std::size_t most = shown_notes_max);

// How many of each kind are kept: the greatest limit at which all kinds together are at most
// `most`. `counts`: notes of each kind.
std::size_t limit_of_each(std::vector<std::size_t> counts, std::size_t most);

}  // namespace lsos
