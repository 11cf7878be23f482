// Changes of one Placemark of a plan's document: where it is, what it is, and new ones of its kind.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "edit/plan_document.h"
#include "plan/kml_source.h"

namespace lsos {

// Puts the Placemark where `wanted` is; a kind of "": nowhere. Places that stay keep their text,
// and others have no altitude. Throws InputError where its place stands in no <coordinates>.
void set_places(PlanDocument& document, const PlanMark& mark, const SourceGeometry& wanted);

// Moves the Point of the document's Placemark with that index, in the order of parse_kml(), to
// "lon,lat".
void move_point(PlanDocument& document, std::size_t index, const std::string& tuple);

// Makes the Placemark one of that type: MissionInfo, Rover, Asset or an event. Its fields stay. The
// type's <Schema> is declared where that of the old one is.
void set_type(PlanDocument& document, PlanMark& mark, const std::string& type);

// Leaves no field but these, in all of its data, and what states its kind.
void keep_fields(PlanDocument& document, const PlanMark& mark,
                 const std::vector<std::string>& names);

// A copy of `like` behind it, or before it, with its style and nothing else that a planner has
// written of that one: no description, view or time.
enum class Beside { behind, before };
PlanMark copy_of_kind(PlanDocument& document, const PlanMark& like, KmlElement beside, Beside side);

}  // namespace lsos
