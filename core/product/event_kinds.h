// Kinds of events, by type, with their colours in the bars under plots.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "plan/declaration.h"
#include "record/rows.h"

namespace lsos {

struct EventKind {
  std::string name;
  std::string colour;  // #rrggbb
  std::vector<std::string> types;
};

// The kinds that scripts declare, then one for each other type among the events as far as there are
// colours; the last kind holds all other types.
std::vector<EventKind> event_kinds(const std::vector<EventRow>& events,
                                   const std::map<std::string, Activity>& activities);

const EventKind& kind_of(const std::vector<EventKind>& kinds, std::string_view event_type);

}  // namespace lsos
