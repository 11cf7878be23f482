-- Fold a solar panel away.

local lsos = require 'lsos'

local function start(ev, rover)
  rover:brake()
  ev.state.takes_s = rover.panels:stow(ev.params.panel, ev.params.duration_s)
  return 'stow'
end

local function stow(ev, _)
  local left_s = ev.state.takes_s - ev.phase_elapsed_s
  if left_s <= 0 then return lsos.done end
  return lsos.sleep(left_s)
end

return lsos.event {
  api    = 1,
  schema = 'StowSP',
  doc    = 'Fold a solar panel away.',

  params = {
    panel      = lsos.text {
      kml = 'Panel', names = 'stowable_panel',
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
