// What lsos.event makes: the declaration, and beside it (user value 1) a Lua table with the
// functions: { phases = { NAME = function or { params = f, geometry = f } }, check = f, route = f,
// on_abort = f, open_ended = f, awaits_sunlight = f }.
#pragma once

#include <string>

#include "plan/declaration.h"

namespace lsos {

inline constexpr const char* event_kind = "event";
inline constexpr const char* sub_event_kind = "sub_event";

// What lsos.sub_event makes; its user value is the table { params = f or table, geometry = f }.
struct SubEvent {
  std::string event;
  std::string next;  // "" when the event is then completed
};

}  // namespace lsos
