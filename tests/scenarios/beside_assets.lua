-- Driving up to an asset, away from it and beside it: what check allows the run does.

local lsos = require 'lsos'

-- A habitat at the origin: its hull lies north to south, 5 m wide and 13 m long.
local function sim_of(start, heading_deg, event, more)
  local rover = { type = 'SEV', at = start, heading_deg = heading_deg, events = { event } }
  for key, value in pairs(more or {}) do rover[key] = value end
  return lsos.sim {
    rovers = { A = rover },
    assets = { Hab = { type = 'Habitat', at = { 0, 0 } } },
  }
end

lsos.scenario('a rover stops before an asset where its line ends before it', function(t)
  for _, north_m in ipairs { 9.6, 10, 11 } do
    local sim = sim_of({ 0, 60 }, 180, { 'Route', at = { 0, north_m } })
    sim:run()
    t:equal(sim:event('A/10').status, 'completed', ('%g m north'):format(north_m))
    -- Positions are counted from the rover's start.
    t:near(sim.rovers.A.position.y, north_m - 60, 1)
  end
end)

lsos.scenario('a planned route ends beside an asset where it was planned to', function(t)
  for _, place in ipairs { { 0, 10 }, { 6.4, 0 }, { -6, 3 } } do
    for _, type in ipairs { 'SEV', 'LRV' } do
      local sim = sim_of({ 40, 60 }, 225, { 'PathPlanRoute', at = place }, { type = type })
      sim:run()
      t:equal(sim:event('A/10').status, 'completed',
        ('%s to %g,%g: %s'):format(type, place[1], place[2], sim:event('A/10').reason or ''))
    end
  end
end)

lsos.scenario('a rover beside an asset sets off the way that it has room to turn', function(t)
  for _, place in ipairs { { 60, 0 }, { 0, -60 }, { 40, 40 } } do
    local sim = sim_of({ 5, 0 }, 0, { 'PathPlanRoute', at = place })
    sim:run()
    t:equal(sim:event('A/10').status, 'completed',
      ('to %g,%g: %s'):format(place[1], place[2], sim:event('A/10').reason or ''))
  end
end)

lsos.scenario('where there is no room to turn beside an asset that is said', function(t)
  -- Its side is half a metre from the hull, and it has to turn to the east.
  local sim = sim_of({ 5, 0 }, 0, { 'Route', at = { 60, 0 } })
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  t:check(sim:event('A/10').reason:find('would touch Hab', 1, true))
end)

lsos.scenario('two rovers at one socket: the second gets nothing, and fails', function(t)
  local event = { 'Recharge', From = 'Hab', Duration = 600 }
  local sim = lsos.sim {
    rovers = {
      A = { type = 'SEV', at = { 15, 0 }, charge = 0.2, events = { event } },
      B = { type = 'SEV', at = { -15, 0 }, charge = 0.2, events = { event } },
    },
    assets = { Hab = { type = 'Habitat', at = { 0, 0 } } },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:equal(sim:event('B/10').status, 'failed')
  t:equal(sim:event('B/10').reason, "Duration is over and no power came from 'Hab'")
end)
