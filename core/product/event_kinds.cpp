#include "product/event_kinds.h"

#include <algorithm>

namespace lsos {

std::span<const EventKind> event_kinds() {
  static const std::vector<EventKind> kinds{
      {"driving", "#7ea3c7", {"Route", "PathPlanRoute"}},
      {"waiting", "#cfd5db", {"Wait", "Pause"}},
      {"energy", "#ecc15a", {"Recharge", "DeploySP", "StowSP", "SteerSP"}},
      {"communication", "#b3a2d8", {"DeployCA", "StowCA"}},
      {"crew", "#7cc2a6", {"EVA"}},
      {"science and use", "#d9a47a", {"Sample", "Drill", "Consume"}},
      {"other", "#a9b7bd", {}},
  };
  return kinds;
}

const EventKind& kind_of(std::string_view event_type) {
  const std::span<const EventKind> kinds = event_kinds();
  const auto found = std::ranges::find_if(
      kinds, [&](const EventKind& kind) { return std::ranges::count(kind.types, event_type) > 0; });
  return found == kinds.end() ? kinds.back() : *found;
}

}  // namespace lsos
