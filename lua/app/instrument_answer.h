// What instruments answer: a JSON array with one object a point for programs, a table for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace lsos {

// How an instrument answers: a table on a terminal and JSON elsewhere, or as it is asked to.
enum class AnswerStyle { by_output, json, text };

using AnswerRow = nlohmann::ordered_json;

// Prints the rows, an array: in the style that is asked, else as a table where standard output is a
// terminal, and as JSON where it is a file or a pipe.
void print_answer(const AnswerRow& rows, AnswerStyle style);

// A line a quantity and a column a row, as many side by side as fit on a screen. Without
// `warnings`, which are long, and are told on standard error.
std::string answer_table(const AnswerRow& rows);

}  // namespace lsos
