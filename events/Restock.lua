-- Fill up something that the rover carries: oxygen, sample bags.

local lsos = require 'lsos'

local reach_m = 20  -- of a hose, as of the cable of Recharge

local function check(p)
  if p.amount == 0 then return nil, 'Amount = 0: nothing is filled up' end
end

local function start(ev, rover)
  local p = ev.params
  rover:brake()
  if not rover:resource(p.resource) then
    return lsos.fail("%s carries no '%s'", rover.id, p.resource)
  end
  local from = p.from and rover:place_of(p.from)
  local away_m = from and (from - rover.position):length() or 0
  if away_m > reach_m then
    return lsos.fail("'%s' is %.0f m away, %g m at most are wanted", p.from, away_m, reach_m)
  end
  return 'fill'
end

local function fill(ev, rover)
  local p = ev.params
  local left_s = p.duration_s - ev.phase_elapsed_s
  if left_s > 0 then return lsos.sleep(left_s) end
  local added = rover:restock(p.resource, p.amount)
  if added == 0 then ev:warn('%s: as much as at the start is there already', p.resource) end
  ev:log('restocked', { resource = p.resource, added = added })
  return lsos.done
end

return lsos.event {
  api    = 1,
  schema = 'Restock',
  doc    = 'Fill up something that the rover carries, to what it had at the start at most.',
  kind   = 'waiting',

  params = {
    resource   = lsos.text {
      kml = 'Resource', names = 'resource', default = 'oxygen',
      doc = 'One that the rover type declares.',
    },
    amount     = lsos.number {
      kml = 'Amount', unit = '1', min = 0,
      doc = 'In its unit; without it all that is missing.',
    },
    from       = lsos.text {
      kml = 'From', names = 'other',
      doc = 'An asset or rover within 20 m that it comes from; without it, from a support crew.',
    },
    duration_s = lsos.duration {
      kml = 'Duration', default = 10, unit = 'min', doc = 'How long it takes.',
    },
  },

  check  = check,
  fills  = function(p) return { [p.resource] = p.amount or math.huge } end,
  start  = 'start',
  phases = { start = start, fill = fill },
}
