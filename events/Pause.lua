-- Stand still for a given time.

local lsos = require 'lsos'

local function check(p)
  if p.duration_s == 0 then return nil, 'Duration = 0: it does nothing' end
end

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
  kind   = 'waiting',

  goes_on_without_power = true,
  params = {
    duration_s = lsos.duration { kml = 'Duration', required = true, doc = 'How long to stay.' },
  },

  check  = check,
  start  = 'pause',
  phases = { pause = pause },

  on_abort = function(ev)
    return ('%.0f s of it were left'):format(ev.params.duration_s - ev.phase_elapsed_s)
  end,
}
