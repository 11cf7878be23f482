-- Put a solar panel up.

local lsos = require 'lsos'

local function start(ev, rover)
  rover:brake()
  local takes_s, moves = rover.panels:deploy(ev.params.panel, ev.params.duration_s)
  ev.state.takes_s = takes_s
  if not moves then
    local name = ev.params.panel
    ev:warn('%s up already: nothing was done', name and ("'%s' is"):format(name) or 'all are')
  end
  return 'deploy'
end

-- One that got stuck on its way says so when it is told again.
local function deploy(ev, rover)
  local left_s = ev.state.takes_s - ev.phase_elapsed_s
  if left_s > 0 then return lsos.sleep(left_s) end
  if ev.state.takes_s > 0 then rover.panels:deploy(ev.params.panel) end
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'DeploySP',
  doc    = 'Put a solar panel up.',

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

  deploys = 'panel',

  start  = 'start',
  phases = { start = start, deploy = deploy },

  -- What moves is not stopped.
  on_abort = function(ev, _)
    local left_s = (ev.state.takes_s or 0) - ev.elapsed_s
    if left_s > 0 then return ('it goes on moving for %.4g s'):format(left_s) end
  end,
}
