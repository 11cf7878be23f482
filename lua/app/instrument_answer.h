// Answers of instruments: a JSON array with one object for each point, or a table for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lsos {

// How an instrument answers: a table on a terminal and JSON elsewhere, or as it is asked to.
enum class AnswerStyle { by_output, json, text };

using AnswerRow = nlohmann::ordered_json;

// Prints the rows, an array, in the given style. `by_output` gives a table where standard output is
// a terminal, and JSON where it is a file or a pipe.
void print_answer(const AnswerRow& rows, AnswerStyle style);

// A table with one line for each quantity and one column for each row, as many side by side as fit
// on a screen. It omits `warnings`, which are long and are printed on standard error.
std::string answer_table(const AnswerRow& rows);

}  // namespace lsos
