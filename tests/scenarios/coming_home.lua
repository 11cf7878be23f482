-- OnFailure of a whole rover and mission: a leg that fails costs its day, not the mission.

local lsos = require 'lsos'

-- Two days of a rover, each a drive, work and the way home. The first drive fails by its Timeout.
local function days()
  return {
    { 'Route', at = { 0, 300 }, Timeout = 60, label = 'out 1' },
    { 'Sample', Duration = '10 min', label = 'work 1' },
    { 'Route', at = { 0, 0 }, ArrivalRadius = 2, OnFailure = 'skip', label = 'Home' },
    { 'Recharge', EnergyLevel = '95 %', OnFailure = 'skip', label = 'Charge' },
    { 'Route', at = { 0, 60 }, ArrivalRadius = 2, label = 'out 2' },
    { 'Sample', Duration = '10 min', label = 'work 2' },
    { 'Route', at = { 0, 0 }, ArrivalRadius = 2, OnFailure = 'skip', label = 'Home' },
  }
end

lsos.scenario('a rover whose leg fails comes home, and goes on the next day', function(t)
  local sim = lsos.sim {
    on_failure = 'goto Home',
    rovers     = { A = { type = 'SEV', charge = 0.9, heading_deg = 0, events = days() } },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  t:equal(sim:event('work 1').status, 'skipped')
  t:equal(sim:event('work 1').reason, "'out 1' failed and goes to 'Home'")
  for _, number in ipairs { 30, 40, 50, 60, 70 } do
    t:equal(sim:event('A/' .. number).status, 'completed', 'A/' .. number)
  end
  local where = sim.rovers.A.position
  t:near(math.sqrt(where.x ^ 2 + where.y ^ 2), 0, 3, 'm from home')
end)

lsos.scenario("the rover's OnFailure comes before the mission's", function(t)
  local sim = lsos.sim {
    on_failure = 'goto Home',
    rovers     = { A = { type = 'SEV', charge = 0.9, on_failure = 'stop', events = days() } },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  t:equal(sim:event('A/30').status, 'not_started')
end)
