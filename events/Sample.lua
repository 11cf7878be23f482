-- Take a sample of the ground, standing still.

local lsos = require 'lsos'

local function check(p, rover)
  if p.power_w > 0 and rover and not rover.battery_capacity_j then
    return nil, ('Power = %g W: %s has no battery, the energy is not counted'):format(p.power_w,
      rover.type)
  end
end

local function start(ev, rover)
  rover:brake()
  if rover.battery then rover:work(ev.params.power_w) end
  return 'work'
end

local function work(ev, _)
  local left_s = ev.params.duration_s - ev.phase_elapsed_s
  if left_s > 0 then return lsos.sleep(left_s) end
  ev:log('sample')
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Sample',
  doc    = 'Take a sample of the ground, standing still.',
  kind   = 'science',

  params = {
    duration_s = lsos.duration {
      kml = 'Duration', unit = 'min', default = 10,
      doc = 'How long it takes.',
    },
    power_w    = lsos.number {
      kml = 'Power', unit = 'W', min = 0, default = 50,
      doc = 'Of the tools meanwhile.',
    },
  },

  check  = check,
  start  = 'start',
  phases = { start = start, work = work },
}
