-- Raise a comm asset.

local lsos = require 'lsos'

local function start(ev, rover)
  rover:brake()
  local takes_s, moves = rover.antennas:deploy(ev.params.asset, ev.params.duration_s)
  ev.state.takes_s = takes_s
  if not moves then
    local name = ev.params.asset
    ev:warn('%s up already: nothing was done', name and ("'%s' is"):format(name) or 'all are')
  end
  return 'deploy'
end

local function deploy(ev, _)
  local left_s = ev.state.takes_s - ev.phase_elapsed_s
  if left_s <= 0 then return lsos.done end
  return lsos.sleep(left_s)
end

return lsos.event {
  api    = 1,
  schema = 'DeployCA',
  doc    = 'Raise a comm asset.',

  params = {
    asset      = lsos.text {
      kml = 'Asset', names = 'antenna',
      doc = "The rover's antenna; without one all that can be stowed.",
    },
    duration_s = lsos.duration {
      kml = 'Duration',
      doc = "How long it takes; without one the antenna's own.",
    },
  },

  deploys = 'asset',

  start  = 'start',
  phases = { start = start, deploy = deploy },

  -- What moves is not stopped.
  on_abort = function(ev, _)
    local left_s = (ev.state.takes_s or 0) - ev.elapsed_s
    if left_s > 0 then return ('it goes on moving for %.4g s'):format(left_s) end
  end,
}
