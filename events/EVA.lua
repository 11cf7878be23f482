-- Crew members leave the rover, work outside, and come back.

local lsos = require 'lsos'

-- Oxygen of one who works outside, kg/h: NASA's Life Support Baseline Values and Assumptions
-- Document (Anderson and others, NASA/TP-2015-218570, rev. 2: Ewert, Chen and Powell 2022).
local oxygen_kgph = 0.075

-- What the suits are filled with before anyone goes out.
local function oxygen_kg(p)
  local outside_s = p.exit_duration_s + p.activity_duration_s + p.entry_duration_s
  return p.crew * oxygen_kgph * outside_s / 3600
end

-- A phase that lasts as long as the parameter says.
local function stay(duration, next)
  return function(ev, rover)
    ev.state.phase = duration:match('^%a+')
    rover:brake()
    if rover.battery then rover:work(ev.params.power_w) end
    local left_s = ev.params[duration] - ev.phase_elapsed_s
    if left_s <= 0 then return next end
    return lsos.sleep(left_s)
  end
end

-- Suits keep a crew for eight hours, with what is in reserve some more.
local longest_s = 24 * 3600

local function check(p, rover)
  if p.exit_duration_s + p.activity_duration_s + p.entry_duration_s == 0 then
    return nil, 'ExitDuration, ActivityDuration and EntryDuration are 0: it does nothing'
  end
  if rover and rover.crew and p.crew > rover.crew then
    local as = rover.configuration and (' (%s)'):format(rover.configuration) or ''
    return nil, ('Crew = %d: %s%s carries %s'):format(p.crew, rover.type, as,
      rover.crew == 0 and 'nobody' or ('a crew of %d'):format(rover.crew))
  end
  if p.activity_duration_s > longest_s then
    return nil, ('ActivityDuration is %.3g h: no suit lasts so long'):format(
      p.activity_duration_s / 3600)
  end
  if p.power_w > 0 and rover and not rover.battery_capacity_j then
    return nil, ('Power = %g W: %s has no battery, the energy is not counted'):format(p.power_w,
      rover.type)
  end
end

-- A rover without stores of oxygen carries suits that are full.
local function start(ev, rover)
  local wanted_kg, left_kg = oxygen_kg(ev.params), rover:resource('oxygen')
  if left_kg and not rover:use('oxygen', wanted_kg) then
    return lsos.fail('%s has only %.3g kg of oxygen, a crew of %d takes %.3g kg out', rover.id,
      left_kg, ev.params.crew, wanted_kg)
  end
  ev:log('eva', { crew = ev.params.crew, oxygen_kg = left_kg and wanted_kg })
  return 'exit'
end

return lsos.event {
  api    = 1,
  schema = 'EVA',
  doc    = 'Crew members leave the rover, work outside, and come back.',
  kind   = 'crew',

  params = {
    exit_duration_s     = lsos.duration {
      kml = 'ExitDuration', unit = 'min', default = 15,
      doc = 'Until they stand outside.',
    },
    activity_duration_s = lsos.duration {
      kml = 'ActivityDuration', unit = 'h', default = 2,
      doc = 'Of their work outside.',
    },
    entry_duration_s    = lsos.duration {
      kml = 'EntryDuration', unit = 'min', default = 15,
      doc = 'Until they are inside again.',
    },
    crew                = lsos.integer {
      kml = 'Crew', min = 1, max = 20, default = 2,
      doc = 'How many go; each takes 0.075 kg of oxygen an hour from what the rover carries.',
    },
    power_w             = lsos.number {
      kml = 'Power', unit = 'W', min = 0, default = 0,
      doc = 'That the rover gives meanwhile, for all of them.',
    },
  },

  check  = check,
  uses   = function(p) return { oxygen = oxygen_kg(p) } end,
  start  = 'start',
  -- What follows would leave them behind.
  on_abort = function(ev, _)
    if not ev.state.phase then return nil end
    return ("cut off in phase '%s': a crew of %d has not come back in"):format(ev.state.phase,
      ev.params.crew)
  end,

  phases = {
    start    = start,
    exit     = stay('exit_duration_s', 'activity'),
    activity = stay('activity_duration_s', 'entry'),
    entry    = stay('entry_duration_s', lsos.done),
  },
}
