// Checks that the types that a document's <Schema>s give to fields suit the values of the fields.
#pragma once

#include "plan/classify.h"

namespace lsos {

// Warns of fields that are typed as numbers but whose text is not a number: map tools truncate
// "6 km/h" to 6 when they read it.
void check_schema_types(const KmlSource& source, const Classified& classified, Faults& faults);

}  // namespace lsos
