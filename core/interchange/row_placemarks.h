// Rows of tables as the Placemarks of a plan.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "interchange/notes.h"
#include "interchange/places.h"
#include "interchange/row_times.h"
#include "interchange/row_types.h"
#include "interchange/thing_fields.h"

namespace lsos {

struct RowPlacemarks {
  std::vector<SourcePlacemark> placemarks;  // one a row, in their order
  std::vector<std::size_t> ways;            // those that drive to several places by name
};

// What the rows say, with days counted from the mission's start. An event without a Sequence has
// an empty one, see number_events(). A row of a thing that was `drawn` stays where it is in a sheet
// without columns of places, whatever it is called. Reports faults of cells; notes how texts were
// understood.
RowPlacemarks placemarks_of(const std::vector<TypedRow>& rows, const Declarations& declarations,
                            const PlaceNames& places, SheetStart start,
                            const std::set<ThingId>& drawn, Notes& notes, Faults& faults);

}  // namespace lsos
