// ev.state as bytes and back: nil, booleans, integers, floats (bit exact), texts, vec3, and tables
// of these with text keys and a dense list part.
#pragma once

#include <lua.hpp>
#include <string>

#include "base/archive.h"
#include "lua/runtime/file_locals.h"

namespace lsos {

// Largest size of the bytes. The state is written after each phase and kept in the log at each
// checkpoint.
inline constexpr std::size_t state_bytes_max = std::size_t{1} << 20;

// Writes the value at `index`, tables in sorted order. Throws std::runtime_error that names the
// path ("ev.state.path[3].f") of what cannot be saved: functions, objects, tables with metatables,
// tables that occur twice or contain themselves, lists with holes, keys that are no texts, and more
// than state_bytes_max. Returns whether scripts can tell the value from what comes back: a table in
// it is one of the file's too, or a vec3 has whole numbers where it would have floating ones.
bool save_value(lua_State* L, int index, const std::string& name, Archive& archive,
                const FileLocals& file);

// Pushes the value that was saved. Throws Archive::Mismatch for damaged bytes.
void restore_value(lua_State* L, Archive& archive);

}  // namespace lsos
