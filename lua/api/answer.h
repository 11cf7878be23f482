// What a phase returns: lsos.done, lsos.fail(...), lsos.sleep(s), ..., a phase name or nothing.
#pragma once

#include <lua.hpp>
#include <string>

#include "mission/port/script_host.h"

namespace lsos {

void push_answer(lua_State* L, PhaseAnswer answer);

// Returns nullptr when the value at `index` is no answer.
const PhaseAnswer* to_answer(lua_State* L, int index);

// The text that string.format makes of all arguments; they are popped.
std::string formatted(lua_State* L);

// Functions of the lsos module.
int answer_fail(lua_State* L);
int answer_sleep(lua_State* L);
int answer_sleep_until(lua_State* L);
int answer_arrival_within(lua_State* L);

// Reads the answer from the values that the phase function left above stack index `base`. Throws
// std::runtime_error for a value that is no answer, and for the name of a phase that the event does
// not have.
PhaseAnswer read_answer(lua_State* L, int base, const EventDeclaration& event);

}  // namespace lsos
