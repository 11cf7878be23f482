#include "product/event_kinds.h"

#include <algorithm>
#include <set>

namespace lsos {

std::vector<EventKind> event_kinds(const std::vector<EventRow>& events) {
  std::vector<EventKind> kinds{
      {"driving", "#7ea3c7", {"Route", "PathPlanRoute", "Rendezvous"}},
      {"waiting", "#cfd5db", {"Wait", "Pause"}},
      {"energy", "#ecc15a", {"Recharge", "DeploySP", "StowSP", "SteerSP"}},
      {"communication", "#b3a2d8", {"DeployCA", "StowCA"}},
      {"crew", "#7cc2a6", {"EVA"}},
      {"science and use", "#d9a47a", {"Sample", "Drill", "Survey", "Consume"}},
  };
  const auto is_known = [&](const std::string& type) {
    return std::ranges::any_of(
        kinds, [&](const EventKind& kind) { return std::ranges::count(kind.types, type) > 0; });
  };
  std::set<std::string> own;
  for (const EventRow& event : events) {
    if (!is_known(event.type)) own.insert(event.type);
  }
  constexpr std::string_view colours_of_own[] = {"#d58aa8", "#8f9a54", "#5fb3b8", "#b5774f",
                                                 "#6f7fc1"};
  for (const std::string_view colour : colours_of_own) {
    if (own.empty()) break;
    const std::string type = own.extract(own.begin()).value();
    kinds.push_back({type, std::string(colour), {type}});
  }
  kinds.push_back({"other", "#a9b7bd", {}});
  return kinds;
}

const EventKind& kind_of(const std::vector<EventKind>& kinds, std::string_view event_type) {
  const auto found = std::ranges::find_if(
      kinds, [&](const EventKind& kind) { return std::ranges::count(kind.types, event_type) > 0; });
  return found == kinds.end() ? kinds.back() : *found;
}

}  // namespace lsos
