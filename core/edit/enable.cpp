#include "edit/enable.h"

namespace lsos {

int set_enabled(PlanDocument& document, const std::vector<const PlanEvent*>& events,
                bool is_enabled) {
  int count = 0;
  for (const PlanEvent* event : events) {
    if (event->is_enabled == is_enabled) continue;
    document.set_field(document.mark(*event), "Enabled", is_enabled ? "true" : "false");
    ++count;
  }
  return count;
}

}  // namespace lsos
