// Rows of tables as the Placemarks of a plan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interchange/notes.h"
#include "interchange/places.h"
#include "interchange/row_types.h"
#include "planet/utc.h"

namespace lsos {

struct RowPlacemarks {
  std::vector<SourcePlacemark> placemarks;  // one a row, in their order
  std::vector<std::size_t> ways;            // those that drive to several places by name
};

// What the rows say, with days counted from the mission's `start`. An event without a Sequence has
// an empty one, see number_events(). Reports faults of cells; notes how texts were understood.
RowPlacemarks placemarks_of(const std::vector<TypedRow>& rows, const Declarations& declarations,
                            const PlaceNames& places, std::optional<Instant> start, Notes& notes,
                            Faults& faults);

}  // namespace lsos
