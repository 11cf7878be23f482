// Output of the program: results on standard output, which must arrive, and messages on standard
// error, which a run survives without.
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace lsos {

// Opens /dev/null for each standard stream that is closed. Otherwise the next file opened would
// take the stream's place, and the program would print into it. To be called before anything is
// opened.
void open_missing_streams();

// All text is written as visible_text(), whether or not a terminal shows it: what is written into a
// file or a pipe ends on a terminal, too.

// Throws OutputError where the text is lost.
void write_result(std::string_view text);
// Flushes all results; throws OutputError where they have not arrived. To be called before an exit
// code reports success.
void flush_results();

// Never throws: a full disk under standard error must not end a mission.
void write_message(std::string_view text) noexcept;

// Draws the line over the last one on a terminal, from its begin on, and ends no line. "" clears
// it.
void redraw_message(std::string_view line) noexcept;

template <class... Values>
void print_result(fmt::format_string<Values...> format, Values&&... values) {
  write_result(fmt::format(format, std::forward<Values>(values)...));
}

template <class... Values>
void print_message(fmt::format_string<Values...> format, Values&&... values) {
  write_message(fmt::format(format, std::forward<Values>(values)...));
}

}  // namespace lsos
