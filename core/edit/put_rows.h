// Puts the rows of a sheet into the document of a plan that was drawn.
#pragma once

#include <vector>

#include "edit/plan_document.h"
#include "edit/row_changes.h"

namespace lsos {

// Changes what the rows change, each in its Placemark; adds Placemarks for those that are new, with
// the style and in the folder of their kin; removes `removed`. All else stays as it was. Throws
// InputError where a place that changes stands in no <coordinates>.
void put_rows(PlanDocument& document, const RowChanges& changes,
              const std::vector<ThingKey>& removed);

}  // namespace lsos
