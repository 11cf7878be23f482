// Numbers of events that were given none.
#pragma once

#include "base/error.h"
#include "plan/kml_source.h"

namespace lsos {

// Gives each event whose field Sequence is empty a number after that of the rover's event before
// it: 10 more, or evenly between those before and after it where they are nearer. Reports an event
// for which no whole number is free. Each Placemark has one SchemaData; those of events stand in
// the order of their rows.
void number_events(KmlSource& plan, Faults& faults);

// Reports events whose Sequence is empty, where it says which event of another plan is meant.
void report_unnumbered(const KmlSource& plan, Faults& faults);

}  // namespace lsos
