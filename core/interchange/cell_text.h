// Texts of cells as a plan writes them.
#pragma once

#include <string>
#include <string_view>

#include "plan/declaration.h"

namespace lsos {

// The text of a field in a plan: with the unit of its column ("5" under "Speed (km/h)" is "5
// km/h"), a point for a decimal comma where `has_commas`, a duration in seconds for "1:30", and
// true or false for "yes", "x" and "no". A text that cannot be read so stays as it is: the reader
// of the plan says what is wrong with it. UTC times are not changed here.
std::string field_text(const std::string& text, const FieldDeclaration& field,
                       const std::string& unit, bool has_commas);

// "2 h" of "2 hours", "80 %" of "80 percent": a number whose unit is spelled out, as a plan reads
// it. `kind` is that of the unit, "duration". Other texts stay as they are.
std::string with_known_unit(const std::string& text, std::string_view kind);

// Why the unit in a column's header cannot be used for a field; "" when it can.
std::string unit_fault(const std::string& unit, const FieldDeclaration& field);

// GDAL writes a text "of:=..." into an ODS workbook as a formula, unless an apostrophe stands in
// front. The second function undoes the first.
std::string guarded_in_ods(const std::string& text);
std::string unguarded_in_ods(const std::string& text);

}  // namespace lsos
