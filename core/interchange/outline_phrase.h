// An event in the words of an outline.
#pragma once

#include <string>

#include "interchange/outline_item.h"

namespace lsos {

// "08:00 drive to Ridge at 5 km/h, ArrivalRadius 5 m, as Up": the item that parse_item() reads as
// exactly these fields, which are Type, StartTime as a clock, Place, the fields of the event and
// its name and description. Words where the grammar has some, else the name of the event.
std::string item_of(const OutlineFields& fields, const Declarations& declarations);

// "Speed 5 km/h, as Ridge": fields after a comma, but for those named in `left_out`.
std::string field_list(const OutlineFields& fields, const std::vector<std::string>& left_out);
// Quotes where a text would be read otherwise without them.
std::string value_text(const std::string& text);

}  // namespace lsos
