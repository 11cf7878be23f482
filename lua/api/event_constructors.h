// Kind of what lsos.event makes: the declaration and, as its user value 1, a Lua table with the
// functions:
//  { phases = { NAME = function or { params = f, geometry = f } }, check = f, route = f,
//    on_abort = f, open_ended = f, awaits_sunlight = f }.
#pragma once

#include <string>

#include "plan/declaration.h"

namespace lsos {

inline constexpr const char* event_kind = "event";
inline constexpr const char* sub_event_kind = "sub_event";

// Value made by lsos.sub_event; its user value is the table { params = f or table, geometry = f }.
struct SubEvent {
  std::string event;
  std::string next;  // "" when the event is completed after it
};

}  // namespace lsos
