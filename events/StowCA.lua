-- Lower a comm asset.

local lsos = require 'lsos'

local function start(ev, rover)
  rover:brake()
  ev.state.ends_s = ev.time_s + rover.antennas:stow(ev.params.asset, ev.params.duration_s)
  return 'stow'
end

local function stow(ev, _)
  if ev.time_s >= ev.state.ends_s then return lsos.done end
  return lsos.sleep_until(ev.state.ends_s)
end

return lsos.event {
  api    = 1,
  schema = 'StowCA',
  doc    = 'Lower a comm asset.',

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

  start  = 'start',
  phases = { start = start, stow = stow },
}
