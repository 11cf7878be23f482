// Forms and styles with which QGIS edits and draws a plan's layers: XML of its version 3.22.
#pragma once

#include <vector>

#include "plan/layer_writer.h"

namespace lsos {

// Sets the style with which QGIS opens each layer: a form with choices, defaults and units, the
// next Sequence over all layers, colours by rover, and labels.
void add_qgis_forms(std::vector<FormLayer>& layers);

}  // namespace lsos
