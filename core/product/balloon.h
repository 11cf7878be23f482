// The balloons of a map: tables of the values of a log's rows, in units that people read.
#pragma once

#include <string>

#include "mission/estimate/event_estimate.h"
#include "planet/utc.h"
#include "record/rows.h"

namespace lsos {

// Each returns HTML. Values that are not modelled are left out.
std::string balloon(const SampleRow& row, Instant start);
std::string balloon(const EventRow& row, Instant start);
std::string balloon(const NoteRow& note, Instant start);
std::string balloon(const PlannedPathRow& row);
std::string balloon(const EventEstimate& event, Instant start);

// A text with what HTML would take for its own.
std::string html_text(const std::string& text);

}  // namespace lsos
