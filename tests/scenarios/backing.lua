-- Rovers that cannot turn on the spot, where they have to back up.

local lsos = require 'lsos'

-- An LRV that faces the north end of a habitat, two metres before it, and is to go beyond.
local function parked_sim(event)
  return lsos.sim {
    rovers = { A = { type = 'LRV', at = { 0, 10 }, heading_deg = 180, events = { event } } },
    assets = { Hab = { type = 'Habitat', at = { 0, 0 } } },
  }
end

lsos.scenario('an LRV that is parked before an asset backs out and drives round it', function(t)
  local sim = parked_sim { 'PathPlanRoute', at = { 0, -40 } }
  local back_m, steps = 0, 0
  while sim:event('A/10').status ~= 'completed' and steps < 600 do
    sim:run_for(1)
    steps = steps + 1
    back_m = math.max(back_m, sim.rovers.A.position.y)
    if sim:event('A/10').status == 'failed' then break end
  end
  t:equal(sim:event('A/10').status, 'completed', sim:event('A/10').reason)
  t:check(back_m > 1, ('it backed up by %.1f m'):format(back_m))
  t:near(sim.rovers.A.position.y, -50, 1)
end)

lsos.scenario('an LRV backs up to a place straight behind it where that is nearer', function(t)
  local sim = parked_sim { 'PathPlanRoute', at = { 0, 16 } }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed', sim:event('A/10').reason)
  t:near(sim.rovers.A.distance_m, 6, 1)
  -- It still faces the habitat.
  t:near(math.deg(sim.rovers.A.heading_rad) % 360, 180, 10)
end)
