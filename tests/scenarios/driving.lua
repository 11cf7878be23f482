-- Events that drive.

local lsos = require 'lsos'

local function sim_of(events, more)
  local plan = { terrain = 'Flat', rovers = { A = { type = 'SEV', events = events } } }
  for key, value in pairs(more or {}) do plan[key] = value end
  return lsos.sim(plan)
end

lsos.scenario('Route goes through its waypoints', function(t)
  local sim = sim_of { { 'Route', path = { { 0, 0 }, { 60, 0 }, { 60, 40 } }, Speed = '5 km/h' } }
  sim:run()
  local rover = sim.rovers.A
  t:equal(sim:event('A/10').status, 'completed')
  t:near(rover.distance_m, '100 m', '4 m', 'driven')
  t:near((rover.position - lsos.vec3(60, 40, 0)):length(), '0 m', '1 m', 'from the last waypoint')
end)

lsos.scenario('PathPlanRoute arrives where a crater is in the way', function(t)
  local sim = sim_of({ { 'PathPlanRoute', at = { 150, 60 } } }, { terrain = 'Craters', seed = 3 })
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:check(sim.rovers.A.distance_m > 160, 'not less than straight')
end)

lsos.scenario('a wheel that locks costs energy', function(t)
  local function used(lock)
    local sim = sim_of { { 'Route', at = { 0, 60 } } }
    if lock then
      sim:set_wheel('A', 'front_left_wheel_1')
      sim:set_wheel('A', 'front_left_wheel_2')
    end
    sim:run()
    return sim:event('A/10').energy_used_j
  end
  t:check(used(true) > 1.05 * used(false), 'two locked wheels drag')
end)

lsos.scenario('Rendezvous follows a rover that moves', function(t)
  local sim = lsos.sim {
    rovers = {
      A = { type = 'SEV', events = { { 'Rendezvous', With = 'B', Distance = '25 m' } } },
      B = {
        type   = 'SEV', at = { 100, 0 },
        events = { { 'Route', at = { 100, 80 }, Speed = '1 km/h' } },
      },
    },
  }
  sim:run_until(function(s) return s:event('A/10').status ~= 'running' end, 600)
  t:equal(sim:event('A/10').status, 'completed')
  local apart_m = (sim.rovers.A.position - sim.rovers.B.position):length()
  t:near(apart_m, '25 m', '3 m', 'apart')
  t:check(sim.rovers.B.position.y > 5, 'it had moved')
end)

lsos.scenario('Survey covers a polygon with samples', function(t)
  local sim = sim_of {
    { 'Survey', polygon = { { 0, 0 }, { 40, 0 }, { 40, 60 }, { 0, 60 } },
      Spacing = 20, SampleEvery = 30, SampleDuration = 30 },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  -- Two lines to the north of 60 m, three stops on each.
  t:equal(sim:notes('survey')[1].fields.stops, 6)
  t:equal(#sim:notes('sample'), 6)
end)

lsos.scenario('another soil is felt', function(t)
  local sim = sim_of { { 'Route', at = { 0, 200 } } }
  sim:run_for(40)
  local before_m = sim.rovers.A.sinkage_m
  sim:set_soil('DrySand')
  sim:run_for(20)
  t:check(sim.rovers.A.sinkage_m < 0.95 * before_m, 'it sinks less in dry sand')
end)

-- A habitat across the way: its hull lies north to south, 5 m wide and 13 m long.
local function sim_with_habitat(event)
  return lsos.sim {
    rovers = { A = { type = 'SEV', heading_deg = 90, events = { event } } },
    assets = { Hab = { type = 'Habitat', at = { 30, 0 } } },
  }
end

lsos.scenario('a planned route goes round an asset', function(t)
  local sim = sim_with_habitat { 'PathPlanRoute', at = { 60, 0 } }
  local nearest_m = math.huge
  sim:run_until(function(s)
    local rover = s.rovers.A
    nearest_m = math.min(nearest_m, math.abs(rover.position.y) + math.abs(rover.position.x - 30))
    return s:event('A/10').status == 'completed'
  end)
  t:equal(sim:event('A/10').status, 'completed')
  t:check(nearest_m > 6, ('%.1f m'):format(nearest_m))
  t:check(sim.rovers.A.distance_m < 75, 'not far round')
end)

lsos.scenario('a planned route leads to a place beside an asset', function(t)
  -- The hull's side is 2.5 m from its middle, the rover's nose less than 3 m from its own.
  local sim = sim_with_habitat { 'PathPlanRoute', at = { 23, 0 } }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
end)

lsos.scenario('a drive ends before an asset that stands in its way', function(t)
  local sim = sim_with_habitat { 'Route', at = { 60, 0 } }
  sim:run()
  local event = sim:event('A/10')
  t:equal(event.status, 'failed')
  t:check(event.reason:find('would touch Hab', 1, true), event.reason)
  t:check(sim.rovers.A.position.x < 26, 'it stands before the hull')
  t:equal(#sim:notes('would_touch'), 1)
end)

lsos.scenario('what the rover has not fails an event without a traceback', function(t)
  local sim = lsos.sim { rovers = { A = { type = 'LRV', events = {
    { 'DeploySP', OnFailure = 'skip' }, { 'Pause', Duration = 1 },
  } } } }
  sim:run()
  t:equal(sim:event('A/10').reason, 'the rover has no solar panels')
end)
