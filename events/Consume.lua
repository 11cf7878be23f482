-- Use energy, or something that the rover carries.

local lsos = require 'lsos'

local function check(p, rover)
  if p.amount and not p.resource then return 'Amount without Resource: of what?' end
  if p.resource and not p.amount then return 'Resource without Amount: how much?' end
  if p.power_w and not p.duration_s then return 'Power without Duration: for how long?' end
  if not (p.power_w or p.resource) then
    return 'nothing is used: Power and Duration, or Resource and Amount, are wanted'
  end
  if p.power_w and rover and not rover.battery_capacity_j then
    return rover.type .. ' has no battery'
  end
  local takes_nothing = not p.resource or p.amount == 0
  if takes_nothing and (not p.power_w or p.power_w == 0 or p.duration_s == 0) then
    return nil, 'nothing is used: a Power, Duration or Amount is 0'
  end
end

local function start(ev, rover)
  local p = ev.params
  rover:brake()
  if p.resource then
    local left = rover:resource(p.resource)
    if not left then return lsos.fail("%s carries no '%s'", rover.id, p.resource) end
    if not rover:use(p.resource, p.amount) then
      return lsos.fail('%s has only %g of %s, %g are wanted', rover.id, left, p.resource, p.amount)
    end
  end
  if p.power_w and not rover.battery then return lsos.fail('%s has no battery', rover.id) end
  if p.power_w then rover:work(p.power_w) end
  if not p.duration_s then return lsos.done end
  return 'consume'
end

local function consume(ev, _)
  local left_s = ev.params.duration_s - ev.phase_elapsed_s
  if left_s <= 0 then return lsos.done end
  return lsos.sleep(left_s)
end

return lsos.event {
  api    = 1,
  schema = 'Consume',
  doc    = 'Use energy, or something that the rover carries.',
  kind   = 'science',

  params = {
    power_w    = lsos.number {
      kml = 'Power', unit = 'W', min = 0, example = '100 W', doc = 'While it lasts.',
    },
    duration_s = lsos.duration { kml = 'Duration', example = '60 s', doc = 'How long it lasts.' },
    resource   = lsos.text {
      kml = 'Resource', names = 'resource',
      doc = 'One that the rover type declares.',
    },
    amount     = lsos.number {
      kml = 'Amount', unit = '1', min = 0, amount_of = 'resource',
      doc = 'Taken at once, in its unit.',
    },
  },

  check  = check,
  start  = 'start',
  phases = { start = start, consume = consume },
}
