#include "lua/session/reference.h"

#include <fmt/format.h>

#include "lua/host/condition.h"
#include "lua/runtime/handle.h"
#include "lua/session/scenario.h"
#include "lua/session/session_api.h"
#include "lua/session/sim_sessions.h"

namespace lsos {

namespace {

constexpr const char* introduction = R"(# Writing scripts

One file is one thing: `events/Route.lua` is the event type `Route`, `rovers/SEV.lua` the rover type
`SEV`, `terrain/Flat.lua` the terrain `Flat`, `terrain/soils/ApolloDense.lua` a soil. A script gets
everything by `local lsos = require 'lsos'` and returns what one constructor made. Scripts are looked
for beside the plan (in the working folder, where there is no plan), then in each folder of
`LSOS_PATH`, then among the shipped ones; the first wins.

What several scripts have in common stands in `lib/`, beside those folders: `local shapes = require
'lib/shapes'` at the head of a file gives the table that `lib/shapes.lua` returns, for reading only.
Each file that requires it gets a copy of its own.

Everything is in SI units, and a name says which: `speed_mps`, `friction_rad`. Positions are in the
site frame: metres to the east, north and up.

## How an event runs

An event is a table of named phases. The engine calls a phase as `phase(ev, rover)`; what it returns
says when it is called next:

| answer | meaning |
|---|---|
| nothing | again at the next exchange, 0.1 s later |
| `'name'` | go on in that phase, now |
| `lsos.sleep(s)`, `lsos.sleep_until(s)` | again then; nothing polls meanwhile |
| `lsos.arrival` | again when `rover:follow` or `rover:follow_rover` has ended |
| `lsos.arrival_within(s)` | the same, or so much later |
| `lsos.done` | the event is completed |
| `lsos.fail(format, ...)` | the event has failed |

Only `ev.state` lives between two calls, as it is saved with the mission: numbers, texts, booleans,
vec3, and tables of these with text keys or as lists. A local variable of the file is not saved; use
it for constants. A phase may be another event:

```lua
local lsos = require 'lsos'

return lsos.event {
  api    = 1,
  doc    = 'Stand still twice as long as the plan says.',
  params = { duration_s = lsos.duration { kml = 'Duration', unit = 'min', required = true } },
  start  = 'first',
  phases = {
    first  = lsos.sub_event {
      event  = 'Pause',
      params = function(ev) return { duration_s = ev.params.duration_s } end,
      next   = 'second',
    },
    second = lsos.sub_event {
      event  = 'Pause',
      params = function(ev) return { duration_s = ev.params.duration_s } end,
    },
  },
}
```

## What is different from plain Lua

Scripts have `assert error ipairs pairs pcall print rawequal rawget rawlen rawset select setmetatable
getmetatable tonumber tostring type xpcall require` and the libraries `math`, `string`, `table`,
`utf8`. So that a mission gives the same log every time and no script can hang it:

- `pairs` goes through numbers in ascending order, then texts by bytes; `table.sort` is stable.
- `lsos.random` is the only source of chance. There is no clock, file, `os`, `io`, `load` or
  `coroutine`.
- Assigning a global, or reading one that is not there, is an error. So is changing in a phase what
  the file's functions reach: a local of the file or of `lib/`, what a table there holds, at any
  depth and under any key, or its metatable; and calling an iterator (`pairs`, `gmatch`) that lies
  there. What lasts lies in `ev.state`. Functions that are no phases, as `check`, find all as the
  file has made it.
- Tables of the file that an event's functions reach have whole numbers from 1 on as keys without a
  hole, or none above 0; `#` of others would depend on what was read of them before. All that these
  functions reach is at most 10 000 values.
- A table of the file that is put into `ev.state` is a copy after the call, and the numbers of a vec3
  there are floating ones.
- A call may take {0} million instructions and make {2} MiB of texts and tables, all scripts together
  {1} MiB of memory. What functions do counts too: steps of a text pattern, keys of `pairs`, bytes of a
  text, 300 for an error that `pcall` catches, 150 000 for `rover:plan_path` with 1000 a leg and
  2.5 a metre as the crow flies: some 1000 km a call. An instruction counts more while there are texts of
  more than 2 KiB, a deep recursion or dozens of metatables. A call that still takes more than {3} s
  of the processor's time, as no ordinary one can, is stopped as well: the one stop that depends on the
  machine. `pcall` catches no spent budget.
- A call may write 1000 rows into the log's notes, of 1 MiB together; `ev.state` may take 1 MiB. Of a
  run's warnings the first 1000 are listed, the others counted; all are in the notes. Its log takes
  50 GB at most, or what `--log-max` says.
- A script may have 1 MiB of text, 1000 `and` and `or` in one expression, 1000 `elseif` in one `if`
  and 2000 `break`, `goto` and labels, and take 1 s of the processor's time to compile. This holds for
  a plan's `Variant` too.
- A folder may have 1000 scripts of a kind. All scripts that are not shipped may have 16 MiB of text
  together, take 100 million instructions, or 20 s of the processor's time, to load, and keep 64 MiB
  of texts and tables.
- A rover has at most 200 arms, knuckles, limb segments and wheels, none farther than 100 m from its
  middle, 100 configurations, 1000 shapes, and 100 panels, loads, resources and antennas each; its
  chassis is at most 100 m long, its shapes, panels and antennas lie within 1000 m.
- A script beyond these limits, or one that cannot be read (a link that leads nowhere, a pipe, a
  folder), is left out as a broken one is: only a plan that uses it is refused, with its name.
- A metatable with `__gc` or `__mode` is refused; set later, neither has an effect.
- `print` writes a row into the log's notes.

An editor with the Lua language server completes and checks scripts by `lua/library.d.lua`.
)";

constexpr const char* conditions = R"(
## Conditions

`StartWhen`, `SkipWhen`, `StopWhen` and `WarnWhen` of any event hold an expression, with `and`, `or`, `not`,
comparisons and `math`, over these quantities of its rover: `charge < 0.3 and sun_fraction == 0`.
They are asked when the event's turn comes (or it starts), then at whole seconds. A quantity that is
not modelled is not-a-number: comparisons with it are false, except `~=`, which is true. What was decided is in the log's notes.
Texts stand for ids: they have no methods here, and there are no tables. A condition may have
4000 characters and take a hundredth of the instructions of a call.

`slip` and `slip_max` are those of driving here: means over the last second in which the wheels were
told to roll at half the requested speed or more, also of a rover that digs itself in. While it sets off,
stops, turns on the spot or stands they are not-a-number. The log has them as they are at the moment.
)";

constexpr const char* scenarios = R"(
## Scenarios

`lsos-host test` runs the files of `tests/scenarios`, or those it is given. One that fails leaves its
log in `out/scenarios`.

```lua
local lsos = require 'lsos'

lsos.scenario('a drive of 60 m stops at its end', function(t)
  local sim = lsos.sim {
    terrain = 'Flat',
    rovers  = { A = { type = 'SEV', events = { { 'Route', at = { 0, 60 }, Speed = '5 km/h' } } } },
  }
  sim:run_for(20)
  t:check(sim.rovers.A.speed_mps > 1, 'it drives')
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:near(sim.rovers.A.distance_m, '60 m', '1 m', 'driven')
end)
```

Events are tables with their type first; names that begin with a capital are fields as a plan has them,
`path`, `at` and `polygon` are places in metres to the east and north of the site, `holes` a list of
such polygons within it, `label` and `sequence` what they say (10, 20, ... when left out).
)";

std::string key_table(const Constructor& constructor) {
  std::vector<KeyDoc> keys;
  TableReader reader(keys);
  constructor.list_keys(reader);
  std::string text = "| key | | |\n|---|---|---|\n";
  for (const KeyDoc& key : keys) {
    text += fmt::format(
        "| {} | {} | {} |\n",
        key.is_required ? fmt::format("**`{}`**", key.key) : fmt::format("`{}`", key.key), key.type,
        key.doc);
  }
  return text;
}

std::string handle_section(const HandleType& type) {
  std::string text =
      fmt::format("\n### `{}`\n\n{}\n\n| | | |\n|---|---|---|\n", type.name, type.doc);
  for (const HandleField& field : type.fields) {
    text += fmt::format("| `{}.{}` | {} | {} |\n", type.name, field.name, field.type, field.doc);
  }
  for (const HandleMethod& method : type.methods) {
    text += fmt::format("| `{}` | function | {} |\n", method.signature, method.doc);
  }
  return text;
}

}  // namespace

const std::vector<const HandleType*>& scripted_objects() {
  static const std::vector<const HandleType*> objects{
      &event_handle_type(),    &geometry_type(),       &rover_handle_type(),
      &drive_handle_type(),    &battery_handle_type(), &panels_handle_type(),
      &antennas_handle_type(), &sim_handle_type(),     &scenario_handle_type()};
  return objects;
}

std::string api_reference() {
  const Limits limits;
  std::string text = introduction;
  const auto fill_in = [&](std::string_view mark, const std::string& value) {
    text.replace(text.find(mark), mark.size(), value);
  };
  fill_in("{0}", std::to_string(limits.instructions / 1'000'000));
  fill_in("{2}", std::to_string((limits.instructions * bytes_per_instruction) >> 20));
  fill_in("{3}", fmt::format("{}", limits.cpu_s));
  fill_in("{1}", std::to_string(limits.memory_bytes >> 20));

  text += "\n## Objects that a phase is given\n";
  const std::size_t of_phases = scripted_objects().size() - 2;
  for (std::size_t i = 0; i < of_phases; ++i) text += handle_section(*scripted_objects()[i]);
  text += conditions;
  text += "\n| | |\n|---|---|\n";
  for (const ConditionName& name : condition_names()) {
    text += fmt::format("| `{}` | {} |\n", name.name, name.doc);
  }
  text += scenarios;
  text += handle_section(sim_handle_type()) + handle_section(scenario_handle_type());
  text += "\n## Functions and values\n\n| | |\n|---|---|\n";
  for (const ApiFunction& entry : all_functions()) {
    text += fmt::format("| `{}` | {} |\n", entry.signature, entry.doc);
  }
  for (const ApiConstant& entry : api_constants()) {
    text += fmt::format("| `lsos.{}` | {} |\n", entry.name, entry.doc);
  }
  text += "\n## Constructors\n\nEach takes one table. Keys in bold are required.\n";
  for (const ApiSection& section : api_sections()) {
    text += fmt::format("\n### {}\n", section.title);
    for (const Constructor& constructor : section.constructors) {
      text += fmt::format("\n#### `lsos.{} {{...}}`\n\n{}\n\n{}", constructor.name, constructor.doc,
                          key_table(constructor));
    }
  }
  return text;
}

}  // namespace lsos
