// The register of the quantities of a rover that a run logs (layer `samples`). The log's columns
// and their titles, conditions, balloons, the report's plots and docs/log.md are made from it. A
// new quantity is a member of SampleRow, an entry in quantity_table.h, and a line where it is
// computed.
#pragma once

#include <span>
#include <string_view>

#include "record/quantity_table.h"

namespace lsos {

// In the order of the log's columns.
std::span<const Quantity> quantities();

// nullptr where there is none of that name.
const Quantity* find_quantity(std::string_view name);

}  // namespace lsos
