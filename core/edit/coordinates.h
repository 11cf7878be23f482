// Places of an edited plan, as KML writes them.
#pragma once

#include <string>

#include "base/vector.h"
#include "edit/plan_document.h"

namespace lsos {

// "31.000123456,20.5", to a tenth of a millimetre.
std::string coordinates_text(const Geodetic& place);

// Moves every place of the text of a <coordinates> by that far east and north; altitudes stay.
std::string moved_coordinates(const std::string& text, const Body& body, const Vec2& offset_m);

// Moves all places of an event. Throws InputError where they stand in no <coordinates>.
void move_places(PlanDocument& document, const PlanMark& mark, const Vec2& offset_m);

// Puts another Point in place of that of a Placemark; the altitude is left out. Throws InputError
// where it stands in no <coordinates>.
void set_point(PlanDocument& document, const PlanMark& mark, const std::string& coordinates);

// Writes the mission's SiteOrigin where the document has none: x, y and generated ground stay where
// they are in its plan, though the first rover is to start elsewhere or another is the first.
void keep_site(PlanDocument& document);

// Puts other ends in place of those of a line; "": that end stays. Altitudes are left out. Throws
// InputError where it stands in no <coordinates>.
void set_line_ends(PlanDocument& document, const PlanMark& mark, const std::string& first,
                   const std::string& last);

}  // namespace lsos
