-- Stand still until a given moment.

local lsos = require 'lsos'

local function wait(ev, rover)
  rover:brake()
  if ev.time_s >= ev.params.until_s then
    return lsos.done
  end
  return lsos.sleep_until(ev.params.until_s)
end

return lsos.event {
  api    = 1,
  schema = 'Wait',
  doc    = 'Stand still until a given moment.',

  goes_on_without_power = true,
  params = {
    until_s = lsos.utc { kml = 'Until', required = true, doc = 'The moment to wait for, in UTC.' },
  },

  start  = 'wait',
  phases = { wait = wait },
}
