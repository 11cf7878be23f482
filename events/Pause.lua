-- Stand still for a given time.

local lsos = require 'lsos'

local function pause(ev, rover)
  rover:brake()
  if ev.phase_elapsed_s >= ev.params.duration_s then
    return lsos.done
  end
  return lsos.sleep(ev.params.duration_s - ev.phase_elapsed_s)
end

return lsos.event {
  api    = 1,
  schema = 'Pause',
  doc    = 'Stand still for a given time.',

  goes_on_without_power = true,
  params = {
    duration_s = lsos.duration { kml = 'Duration', required = true, doc = 'How long to stay.' },
  },

  start  = 'pause',
  phases = { pause = pause },
}
