// What events are, by type, and the colour of it in bars under plots.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "record/rows.h"

namespace lsos {

struct EventKind {
  std::string name;
  std::string colour;  // #rrggbb
  std::vector<std::string> types;
};

// Of the shipped types; then one for each type of a user's own that is among the events, as far as
// there are colours; the last is that of all other types.
std::vector<EventKind> event_kinds(const std::vector<EventRow>& events);

const EventKind& kind_of(const std::vector<EventKind>& kinds, std::string_view event_type);

}  // namespace lsos
