// Ways in which an event's script could remember something beside ev.state, which is all that a
// mission saves. Each must hold nothing or be refused.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace lsos::test {

struct HiddenState {
  std::string name;
  std::string head;         // what stands at the head of the script
  std::string step;         // what the phase does: sets `seen` to what it remembers
  std::string refusal;      // part of the message; "": it holds nothing
  std::string shared = "";  // of lib/NAME.lua, which it requires
};

inline std::ostream& operator<<(std::ostream& out, const HiddenState& way) {
  return out << way.name;
}

// The event script of a way, which writes at each exchange what it remembers into the log.
inline std::string event_of(const HiddenState& way) {
  return "local lsos = require 'lsos'\n" + way.head +
         "\nlocal function go(ev, rover)\n  local seen\n" + way.step +
         "\n  ev:log('seen', { what = tostring(seen) })\n"
         "  if ev.elapsed_s > 0.35 then return lsos.done end\nend\n"
         "return lsos.event { api = 1, doc = 'Remembers.', phases = { go = go } }\n";
}

inline std::vector<HiddenState> hidden_states() {
  const auto changed = [](const std::string& name) {
    return "it changed '" + name + "', a local of the file";
  };
  const auto called = [](const std::string& name) {
    return "it called '" + name + "', an iterator in a local of the file";
  };
  const std::string holds_nothing;
  return {
      {"Local", "local n = 0", "n = n + 1 seen = n", changed("n")},
      {"NoValueYet", "local text", "seen = text text = 'kept'", changed("text")},
      {"Function",
       "local function one() return 1 end\nlocal function two() return 2 end\nlocal turn = one",
       "seen = turn() turn = two", changed("turn")},
      {"FunctionMadeThen", "local turn", "seen = turn and turn() turn = function() return 2 end",
       changed("turn")},
      {"KindOfNumber", "local n = 1", "seen = math.type(n) n = 1.0", changed("n")},
      {"SignOfZero", "local n = 0.0", "seen = 1 / n n = -0.0", changed("n")},
      {"BitsOfNaN", "local n = 0 / 0",
       "seen = string.byte(string.pack('<d', n)) n = string.unpack('<d', "
       "'\\7\\0\\0\\0\\0\\0\\xf8\\x7f')",
       changed("n")},
      {"KindOfNumberInTable", "local t = { n = 1 }", "seen = math.type(t.n) t.n = 1.0",
       changed("t")},
      {"Environment", "local env = _ENV",
       "seen = rawget(_ENV, 'n') _ENV = env.setmetatable({ n = 1 }, { __index = env })",
       changed("_ENV")},
      {"LocalEnvironment",
       "local outer = _ENV\nlocal _ENV = outer.setmetatable({ n = 0 }, { __index = outer })",
       "n = n + 1 seen = n", changed("_ENV")},
      {"DeepTable", "local t = { a = { b = { c = { d = { e = { n = 0 } } } } } }",
       "local e = t.a.b.c.d.e e.n = e.n + 1 seen = e.n", changed("t")},
      {"BooleanKey", "local t = { [true] = { n = 0 } }",
       "t[true].n = t[true].n + 1 seen = t[true].n", changed("t")},
      {"FractionKey", "local t = { [0.5] = { n = 0 } }", "t[0.5].n = t[0.5].n + 1 seen = t[0.5].n",
       changed("t")},
      {"FunctionKey", "local t = { [print] = { n = 0 } }",
       "t[print].n = t[print].n + 1 seen = t[print].n", changed("t")},
      {"TableInItself", "local t = { n = 0 }\nt.t = t", "t.t.t.n = t.n + 1 seen = t.n",
       changed("t")},
      {"Vec3", "local at = lsos.vec3(0, 0)", "at.x = at.x + 1 seen = at.x", changed("at")},
      {"OneOfManyLocals",
       "local f = {}\nfor k = 1, 150 do local n = 0 f[k] = function() n = n + 1 return n end end",
       "seen = f[150]()", changed("n")},
      {"LoopVariable", "local f\nfor k = 1, 1 do f = function() k = k + 1 return k end end",
       "seen = f()", changed("k")},
      {"OneOfManyFunctions",
       "local f = {}\nfor k = 1, 1500 do f[k] = function() k = k + 1 return k end end",
       "seen = f[1500]()", changed("k")},
      {"OneOfManyEntries", "local t = {}\nfor k = 1, 3000 do t[k] = 0 end",
       "t[3000] = t[3000] + 1 seen = t[3000]", changed("t")},
      {"DeepFunction",
       "local t\ndo local n = 0 t = { { { { { function() n = n + 1 return n end } } } } } end",
       "seen = t[1][1][1][1][1]()", changed("n")},
      {"FunctionBehindBoolean",
       "local t\ndo local n = 0 t = { [false] = function() n = n + 1 return n end } end",
       "seen = t[false]()", changed("n")},
      {"FunctionBehindIndex",
       "local t\ndo local n = 0 t = setmetatable({}, { __index = function() n = n + 1 return n "
       "end, "
       "__metatable = false }) end",
       "seen = t.n", changed("n")},
      {"TableBehindMetatable",
       "local t\ndo local kept = { n = 0 }\n  t = setmetatable({}, { __index = kept, __newindex = "
       "kept, __metatable = false })\nend",
       "t.n = t.n + 1 seen = t.n", changed("t")},
      {"MetatableOfMetatable", "local t = setmetatable({}, setmetatable({}, { n = 0 }))",
       "local m = getmetatable(getmetatable(t)) m.n = m.n + 1 seen = m.n", changed("t")},
      {"OtherMetatable", "local t = setmetatable({}, { n = 0 })",
       "seen = getmetatable(t).n setmetatable(t, { n = seen + 1 })", changed("t")},
      {"IteratorOfGmatch", "local letters = ('abcdefgh'):gmatch('%a')", "seen = letters()",
       called("letters")},
      {"IteratorOfPairs", "local each = pairs({ a = 1, b = 2, c = 3, d = 4, e = 5, f = 6 })",
       "seen = each()", called("each")},
      {"IteratorInTable", "local t = { [true] = { { ('abcdefgh'):gmatch('%a') } } }",
       "seen = t[true][1][1]()", called("t")},
      {"IteratorOfCodes", "local each, text = utf8.codes('abcdefgh')", "seen = each(text, 0)",
       holds_nothing},
      {"AddedAndRemoved", "local t = {}", "t.n = 1 seen = t.n t.n = nil", holds_nothing},
      {"LengthWithHoles",
       "local t = { 1, 2, 3, 4, 5, 6, 7, 8, 9, nil, 11, nil, nil, nil, nil, nil }",
       "seen = #t + (t[11] - 11)", "[11] without [10]"},
      {"WeakTable", "local t = setmetatable({}, { __mode = 'k' })", "seen = 1",
       "a metatable with '__mode' is not allowed"},
      {"StateIsTableOfFile", "local t = {}", "seen = ev.state == t ev.state = t", holds_nothing},
      {"StateHasTableOfFile", "local t = { at = lsos.vec3(1, 2) }",
       "seen = ev.state.at == nil or rawequal(ev.state.at, t.at) ev.state.at = t.at",
       holds_nothing},
      {"StateChangesTableOfFile", "local t = {}", "seen = #t ev.state.t = t ev.state.t[1] = 1",
       changed("t")},
      {"KindOfNumberInVec3", "",
       "ev.state.at = ev.state.at or lsos.vec3(1, 2) seen = math.type(ev.state.at.x) ev.state.at.x "
       "= 1",
       holds_nothing},
      {"FunctionInState", "", "ev.state.f = function() end",
       "ev.state.f: a function cannot be saved"},
      {"MetatableInState", "", "ev.state.t = setmetatable({}, {})",
       "ev.state.t: a table with a metatable cannot be saved"},
      {"OfTheProgram", "", "lsos.n = 1", "lsos is read-only"},
      {"OfALibrary", "", "rawset(string, 'n', 1)", "rawset on a table that is read-only"},
      {"OfTexts", "", "getmetatable('').n = 1", "attempt to index a boolean value"},
      {"OfVectors", "", "getmetatable(lsos.vec3(0, 0)).n = 1", "attempt to index a boolean value"},
      {"Global", "", "n = 1", "assignment to global 'n'"},
      {"RawGlobal", "", "rawset(_ENV, 'n', 1)", "rawset on a table that is read-only"},
      {"FieldOfParams", "", "rawset(ev.params, 'n', 1)", "rawset on a table that is read-only"},
      {"FieldOfEvent", "", "ev.n = 1", "ev is read-only"},
      {"FieldOfRover", "", "rover.n = 1", "rover is read-only"},
      {"LocalOfShared", "local kept = require 'lib/LocalOfShared'", "seen = kept.add()",
       changed("n"), "local n = 0\nreturn { add = function() n = n + 1 return n end }"},
      {"TableOfShared", "local kept = require 'lib/TableOfShared'",
       "kept.t.n = kept.t.n + 1 seen = kept.t.n", changed("kept"), "return { t = { n = 0 } }"},
      {"IteratorOfShared", "local kept = require 'lib/IteratorOfShared'", "seen = kept.letters()",
       called("kept"), "return { letters = ('abcdefgh'):gmatch('%a') }"},
      {"EnvironmentOfShared", "local kept = require 'lib/EnvironmentOfShared'", "seen = kept.add()",
       changed("_ENV"),
       "local outer = _ENV\nlocal _ENV = outer.setmetatable({ n = 0 }, { __index = outer })\n"
       "return { add = function() n = n + 1 return n end }"},
  };
}

}  // namespace lsos::test
