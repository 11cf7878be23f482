// What events are, by type, and the colour of it in bars under plots.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lsos {

struct EventKind {
  std::string_view name;
  std::string_view colour;  // #rrggbb
  std::vector<std::string_view> types;
};

// The last is that of all other types: events of a user's own.
std::span<const EventKind> event_kinds();
const EventKind& kind_of(std::string_view event_type);

}  // namespace lsos
