// What instruments answer: a JSON array with one object a point for programs, a table for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "lua/commands.h"

namespace lsos {

using AnswerRow = nlohmann::ordered_json;

// Rounded to that many decimals, so that 0.3 is not written 0.30000000000000004.
double with_decimals(double value, int decimals);
// A place as it was asked, without the digits of a turn into radians and back.
double asked_deg(double angle_deg);
// What was computed, to 1e-9 degrees, 1e-9 of a share, or a nanometre.
double computed(double value);

// Prints the rows, an array: in the style that is asked, else as a table where standard output is a
// terminal, and as JSON where it is a file or a pipe.
void print_answer(const AnswerRow& rows, AnswerStyle style);

// A line a quantity and a column a row, as many side by side as fit on a screen. Without
// `warnings`, which are long, and are told on standard error.
std::string answer_table(const AnswerRow& rows);

}  // namespace lsos
