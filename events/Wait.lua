-- Stand still until a given moment.

local lsos = require 'lsos'

local function wait(ev, rover)
  rover:brake()
  local left_s = ev.params.until_s - ev.time_s
  if left_s < -0.1 and ev.phase_elapsed_s == 0 then
    ev:warn('Until was over %.4g s before its turn came', -left_s)
  end
  if left_s <= 0 then return lsos.done end
  return lsos.sleep_until(ev.params.until_s)
end

return lsos.event {
  api    = 1,
  schema = 'Wait',
  doc    = 'Stand still until a given moment.',
  kind   = 'waiting',

  goes_on_without_power = true,
  params = {
    until_s = lsos.utc { kml = 'Until', required = true, doc = 'The moment to wait for, in UTC.' },
  },

  start  = 'wait',
  phases = { wait = wait },

  on_abort = function(ev)
    return ('Until was %.0f s away'):format(ev.params.until_s - ev.time_s)
  end,
}
