// Values of a plan as planners write them: in a unit of their choice, and equal to the last bit.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/units.h"
#include "plan/declaration.h"

namespace lsos {

// A field's text with what declares it.
using DeclaredText = std::pair<const FieldDeclaration*, std::string>;

// Whether the field's numbers have a unit that a header may say.
bool has_unit(const FieldDeclaration& field);

// The text for a cell below a header with that unit, such that field_text() makes the same value of
// it: "5" of "5 km/h" in km/h, and the text with its own unit where no number does. "" when neither
// does.
std::string text_in_unit(const std::string& text, const FieldDeclaration& field, const Unit& unit);

// The unit in which these texts are shortest together, of those that they are written in; where
// they have none, of the field's and of those that people use for its kind. nullptr when a header
// can say none for all of them.
const Unit* shortest_unit(const std::vector<DeclaredText>& texts);

// The value with its unit, as in an outline: "2 h" of "7200". The text itself where no other is
// equal to it.
std::string text_with_unit(const std::string& text, const FieldDeclaration& field);

}  // namespace lsos
