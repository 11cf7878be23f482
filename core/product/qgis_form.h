// How QGIS asks for the fields of a plan's layers, and draws them: XML of its version 3.22.
#pragma once

#include <vector>

#include "plan/layer_writer.h"

namespace lsos {

// Gives each layer the style under which QGIS opens it: a form with choices, defaults and units,
// the next Sequence over all layers, colours by rover, and labels.
void add_qgis_forms(std::vector<FormLayer>& layers);

}  // namespace lsos
