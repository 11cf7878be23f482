-- Fold a solar panel away.

local lsos = require 'lsos'

local function start(ev, rover)
  rover:brake()
  ev.state.ends_s = ev.time_s + rover.panels:stow(ev.params.panel, ev.params.duration_s)
  return 'stow'
end

local function stow(ev, _)
  if ev.time_s >= ev.state.ends_s then return lsos.done end
  return lsos.sleep_until(ev.state.ends_s)
end

return lsos.event {
  api    = 1,
  schema = 'StowSP',
  doc    = 'Fold a solar panel away.',

  params = {
    panel      = lsos.text {
      kml = 'Panel', names = 'panel',
      doc = 'Its name; without one all that can be stowed.',
    },
    duration_s = lsos.duration {
      kml = 'Duration',
      doc = "How long it takes; without one the panel's own.",
    },
  },

  start  = 'start',
  phases = { start = start, stow = stow },
}
