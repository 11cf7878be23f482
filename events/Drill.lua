-- Drill into the ground, standing still.

local lsos = require 'lsos'

local function check(p, rover)
  if p.depth_m == 0 then return nil, 'Depth = 0: there is no hole' end
  if p.depth_m > 10 then
    return nil, ("Depth = %g m: no drill that a rover carries goes as deep; did you mean '%g cm'?")
      :format(p.depth_m, p.depth_m)
  end
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
  ev:log('hole', { depth_m = ev.params.depth_m })
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Drill',
  doc    = 'Drill into the ground, standing still.',
  kind   = 'science',

  params = {
    duration_s = lsos.duration {
      kml = 'Duration', unit = 'min', default = 60,
      doc = 'How long it takes.',
    },
    power_w    = lsos.number {
      kml = 'Power', unit = 'W', min = 0, default = 300,
      doc = 'Of the tools meanwhile.',
    },
    depth_m    = lsos.number {
      kml = 'Depth', unit = 'm', min = 0, max = 100, default = 1,
      doc = 'Of the hole; it is logged.',
    },
  },

  check  = check,
  start  = 'start',
  phases = { start = start, work = work },
}
