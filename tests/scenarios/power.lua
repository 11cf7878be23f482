-- Power that events ask for, assets give and conditions look at.

local lsos = require 'lsos'

-- High Sun: the middle of the Moon's near side at its noon.
local noon = '2026-07-29T14:00:00Z'

lsos.scenario('an event within another uses power only while it runs', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type   = 'Husky',
        events = {
          { 'Survey', polygon = { { 0, 0 }, { 30, 0 }, { 30, 10 }, { 0, 10 } }, Spacing = 10,
            SampleEvery = 10, SampleDuration = 10, SamplePower = 400 },
        },
      },
    },
  }
  local battery = sim.rovers.A.battery
  local function samples() return #sim:notes('sample') > 0 and battery.load_w >= 400 end
  t:check(sim:run_until(samples), 'power while one is taken')
  sim:run_for(15)
  t:equal(sim:event('A/10').status, 'running', 'on its way to the next')
  t:check(sim.rovers.A.battery.load_w < 100, 'no power of a sample that is over')
end)

lsos.scenario('a resource that is used in equal parts lasts for all of them', function(t)
  local events = {}
  for _ = 1, 5 do events[#events + 1] = { 'Consume', Resource = 'oxygen', Amount = 4.8 } end
  local sim = lsos.sim { rovers = { A = { type = 'SEV', events = events } } }
  sim:run()
  t:equal(sim:event('A/50').status, 'completed')
  t:equal(sim.rovers.A:resource('oxygen'), 0.0)
end)

lsos.scenario('conditions know what flows, also at the start and between events', function(t)
  local sim = lsos.sim {
    start  = noon,
    rovers = {
      A = {
        type   = 'SEV',
        events = {
          { 'Recharge', EnergyLevel = '20%', SkipWhen = 'solar_available_w < 100 or load_w < 10' },
          { 'Pause', Duration = 10, SkipWhen = 'charge > 0.5' },
          { 'Drill', Duration = 10, Power = 300 },
          { 'Pause', Duration = 10, SkipWhen = 'load_w > 800' },
        },
      },
    },
  }
  sim:run()
  for _, event in ipairs(sim.events) do t:equal(event.status, 'completed', event.label) end
end)

lsos.scenario('shade and stuck panels are seen at once, however seldom is logged', function(t)
  local sim = lsos.sim {
    start  = noon, parked_log_interval_s = 600,
    rovers = { A = { type = 'SEV', charge = 0.5, events = { { 'Pause', Duration = '1 h' } } } },
  }
  sim:run_for(10)
  sim:shade('A', 0)
  local before_j = sim.rovers.A.battery.energy_j
  sim:run_for(300)
  local load_w = sim.rovers.A.battery.load_w
  t:near(sim.rovers.A.battery.energy_j - before_j, -load_w * 300 / 0.95, 0.1 * load_w * 300)
end)

lsos.scenario('an asset gives what a full rover leaves to the next', function(t)
  local function rover(x_m, charge)
    return {
      type = 'SEV', at = { x_m, 0 }, charge = charge,
      events = { { 'Recharge', From = 'Array', Duration = '3 h' } },
    }
  end
  local sim = lsos.sim {
    start = noon, rovers = { A = rover(-8, 0.95), B = rover(8, 0.2) },
    assets = { Array = { type = 'SolarArray', at = { 0, 8 } } },
  }
  sim:run_for(60)
  t:near(sim.rovers.B.battery.external_w, 0, 0, 'the first takes all')
  sim:run_for('1 h')
  t:equal(sim.rovers.A.battery.charge, 1.0)
  t:check(sim.rovers.B.battery.external_w > 1000, 'the rest is for the second')
end)

lsos.scenario('durations in other units are over when they are', function(t)
  local sim = lsos.sim {
    rovers = {
      A = {
        type = 'SEV',
        events = {
          { 'Pause', Duration = '0.07 h' }, { 'Pause', Duration = 0.1 },
          { 'StowSP', Duration = 0.2 }, { 'Sample', Duration = '8.3 min' },
        },
      },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').end_s, 252.0)
  t:equal(sim:event('A/30').end_s, 252.3)
  t:near(sim:event('A/40').end_s, 252.3 + 498, 1e-6)
end)

lsos.scenario('a generator feeds the battery day and night', function(t)
  local sim = lsos.sim {
    planet = 'Mars',
    rovers = {
      A = { type = 'MSL', charge = 0.5, events = { { 'Recharge', UntilCharge = 0.55 } } },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  -- 110 W less 50 W of avionics, 0.95 of which the battery keeps; a twentieth of its 2352 Wh.
  local takes_s = 0.05 * 2 * 42 * 28 * 3600 / ((110 - 50) * 0.95)
  t:near(sim:event('A/10').end_s, takes_s, 61, 'as long as the balance says')
  t:near(sim.rovers.A.battery.external_w, '110 W', '1e-6 W')
  t:equal(sim.rovers.A.battery.generator_w, 110)
end)
