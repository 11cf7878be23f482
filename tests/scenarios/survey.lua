-- Surveys keep out of holes and within outlines that cut in.

local lsos = require 'lsos'

local function is_within(p, west, south, east, north)
  return p.x > west and p.x < east and p.y > south and p.y < north
end

-- Runs it, and answers the least that `of` gives of the rover's places, some metres apart.
local function drive(sim, of)
  local least = math.huge
  while not sim.is_finished do
    sim:run_for(2)
    least = math.min(least, of(sim.rovers.A.position))
  end
  return least
end

lsos.scenario('a survey drives round a hole and samples none of it', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type = 'SEV', at = { 0, 0 },
        events = {
          { 'Survey', polygon = { { 0, 0 }, { 80, 0 }, { 80, 60 }, { 0, 60 } },
            holes = { { { 25, 20 }, { 55, 20 }, { 55, 45 }, { 25, 45 } } },
            SampleDuration = 5, SampleEvery = 40 },
        },
      },
    },
  }
  -- How far outside the hole, m; below 0 in it.
  local function outside(p)
    return math.max(25 - p.x, p.x - 55, 20 - p.y, p.y - 45)
  end
  local least_m = drive(sim, outside)
  t:equal(sim:event('A/10').status, 'completed', sim:event('A/10').reason)
  local margin_m = sim.rovers.A.length_m
  t:check(least_m > margin_m - 1.5, 'nearest ' .. least_m)
  local samples = sim:notes('sample')
  t:equal(#samples, sim:notes('survey')[1].fields.stops)
  -- Four lines of 60 m to the north; the two in the middle are cut into parts of 15 m.
  t:equal(#samples, 3 + 2 * 2 + 2 * 2 + 3)
end)

lsos.scenario('a survey of a bay goes round it', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type = 'SEV', at = { 5, 5 },
        events = {
          { 'Survey',
            polygon = { { 0, 0 }, { 80, 0 }, { 80, 60 }, { 55, 60 }, { 55, 20 }, { 25, 20 },
              { 25, 60 }, { 0, 60 } },
            SampleDuration = 5, SampleEvery = 40 },
        },
      },
    },
  }
  local function depth(p) return is_within(p, 25, 20, 55, 60) and -1 or 1 end
  t:equal(drive(sim, depth), 1, 'never in the bay')
  t:equal(sim:event('A/10').status, 'completed')
end)

lsos.scenario('a survey may pass along the very edge of a hole', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type = 'SEV', at = { 0, 0 },
        events = {
          { 'Survey', polygon = { { 0, 0 }, { 60, 0 }, { 60, 40 }, { 0, 40 } },
            holes = { { { 20, 10 }, { 40, 10 }, { 40, 30 }, { 20, 30 } } },
            Margin = 0, SampleDuration = 5, SampleEvery = 50 },
        },
      },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed', sim:event('A/10').reason)
end)

lsos.scenario('a survey without holes keeps no margin in a narrow neck', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type = 'SEV', at = { 5, 5 },
        events = {
          { 'Survey',
            polygon = { { 0, 0 }, { 30, 0 }, { 30, 14.5 }, { 40, 14.5 }, { 40, 0 }, { 70, 0 },
              { 70, 30 }, { 40, 30 }, { 40, 15.5 }, { 30, 15.5 }, { 30, 30 }, { 0, 30 } },
            SampleDuration = 5, SampleEvery = 40 },
        },
      },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed', sim:event('A/10').reason)
  t:equal(#sim:notes('warning'), 0)
end)
