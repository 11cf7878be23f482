#include "product/event_kinds.h"

#include <algorithm>
#include <set>

namespace lsos {

std::vector<EventKind> event_kinds(const std::vector<EventRow>& events,
                                   const std::map<std::string, Activity>& activities) {
  // In the order of Activity.
  std::vector<EventKind> kinds{{"driving", "#7ea3c7", {}}, {"waiting", "#cfd5db", {}},
                               {"energy", "#ecc15a", {}},  {"communication", "#b3a2d8", {}},
                               {"crew", "#7cc2a6", {}},    {"science and use", "#d9a47a", {}}};
  for (const auto& [type, activity] : activities) {
    kinds[static_cast<std::size_t>(activity) - 1].types.push_back(type);
  }
  std::set<std::string> own;
  for (const EventRow& event : events) {
    if (!activities.contains(event.type)) own.insert(event.type);
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
