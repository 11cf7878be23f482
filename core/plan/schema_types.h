// Whether the types that a document's <Schema>s give to fields suit what stands in them.
#pragma once

#include "plan/classify.h"

namespace lsos {

// Warns where a field that is typed as a number has a text that is none: map tools cut "6 km/h"
// to 6 when they read it.
void check_schema_types(const KmlSource& source, const Classified& classified, Faults& faults);

}  // namespace lsos
