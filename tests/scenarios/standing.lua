-- Events that stand still: how long they take and what they use.

local lsos = require 'lsos'

local function rover(events, more)
  local of = { type = 'SEV', events = events }
  for key, value in pairs(more or {}) do of[key] = value end
  return { A = of }
end

lsos.scenario('Pause lasts as long as it says', function(t)
  local sim = lsos.sim { rovers = rover { { 'Pause', Duration = '10 min' } } }
  sim:run()
  local pause = sim:event('A/10')
  t:equal(pause.status, 'completed')
  t:near(pause.end_s - pause.start_s, '10 min', '0 s', 'duration')
  t:equal(sim.rovers.A.distance_m, 0.0)
end)

lsos.scenario('Wait ends at its time, whenever it begins', function(t)
  local sim = lsos.sim {
    start  = '2026-07-01T00:00:00Z',
    rovers = rover {
      { 'Pause', Duration = 90 },
      { 'Wait', Until = '2026-07-01T00:05:00Z' },
      { 'Wait', Until = '2026-07-01T00:01:00Z' },
    },
  }
  sim:run()
  t:near(sim:event('A/20').end_s, '5 min', '0 s')
  t:near(sim:event('A/30').end_s, '5 min', '0 s', 'a time that is past')
end)

lsos.scenario('EVA goes through its three phases and uses its power', function(t)
  local sim = lsos.sim {
    rovers = rover {
      { 'EVA', ExitDuration = '10 min', ActivityDuration = '1 h', EntryDuration = '5 min',
        Crew = 2, Power = 400 },
      { 'Pause', Duration = '75 min' },
    },
  }
  sim:run_for(60)
  t:equal(sim:event('A/10').status, 'running')
  sim:run()
  local eva, pause = sim:event('A/10'), sim:event('A/20')
  t:near(eva.end_s - eva.start_s, '75 min', '0 s')
  t:near(eva.energy_used_j - pause.energy_used_j, 400 * 75 * 60 / 0.95, 400 * 75 * 60 * 0.06)
  t:equal(sim:notes('eva')[1].fields.crew, 2)
end)

lsos.scenario('Sample and Drill work, use power and log what they did', function(t)
  local sim = lsos.sim {
    rovers = rover {
      { 'Sample', Duration = '5 min', Power = 100 },
      { 'Drill', Duration = '1 h', Power = 300, Depth = '2 m' },
    },
  }
  sim:run()
  t:near(sim:event('A/20').end_s, '65 min', '0 s')
  t:equal(#sim:notes('sample'), 1)
  t:near(sim:notes('hole')[1].fields.depth_m, '2 m', '0 m')
  t:check(sim:event('A/20').energy_used_j > 300 * 3600, 'the drill has used its power')
end)

lsos.scenario('Consume takes a resource until there is none', function(t)
  local sim = lsos.sim {
    rovers = rover {
      { 'Consume', Resource = 'oxygen', Amount = 20 },
      { 'Consume', Resource = 'oxygen', Amount = 20, OnFailure = 'skip' },
      { 'Consume', Power = '1 kW', Duration = '1 h' },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:equal(sim:event('A/20').status, 'failed')
  t:check(sim:event('A/20').reason:find('has only 4 of oxygen', 1, true), 'the reason')
  t:near(sim.rovers.A:resource('oxygen'), 4, 0)
  t:check(sim:event('A/30').energy_used_j > 3.6e6, 'one kWh and the losses')
end)

lsos.scenario('EVAs take oxygen until there is none, and Restock brings more', function(t)
  local sim = lsos.sim {
    rovers = rover {
      { 'EVA', ActivityDuration = '90 min', Crew = 2 },
      { 'Consume', Resource = 'oxygen', Amount = 23.5 },
      { 'EVA', ActivityDuration = '90 min', Crew = 2, OnFailure = 'skip' },
      { 'Restock', Amount = 1 },
      { 'EVA', ActivityDuration = '90 min', Crew = 2 },
      { 'Restock', From = 'Habitat' },
      { 'Restock' },
    },
    assets = { Habitat = { type = 'Habitat', at = { 0, 30 } } },
  }
  sim:run()
  -- 2 h with exit and entry, at 0.075 kg an hour for each of two: 0.3 kg.
  t:near(sim:notes('eva')[1].fields.oxygen_kg, 0.3, 1e-9)
  t:equal(sim:event('A/30').status, 'failed')
  t:equal(sim:event('A/30').reason, 'A has only 0.2 kg of oxygen, a crew of 2 takes 0.3 kg out')
  t:near(sim:event('A/30').end_s - sim:event('A/30').start_s, 0, 0, 's: nobody went out')
  t:equal(sim:event('A/50').status, 'completed')
  t:equal(sim:event('A/60').status, 'failed')
  t:check(sim:event('A/60').reason:find("'Habitat' is 30 m away, 20 m at most", 1, true),
    sim:event('A/60').reason)
  t:near(sim.rovers.A:resource('oxygen'), 0.9, 1e-9)
end)

lsos.scenario('Restock beside a habitat fills up to what there was at the start', function(t)
  local sim = lsos.sim {
    rovers = rover {
      { 'Consume', Resource = 'oxygen', Amount = 10 },
      { 'Restock', From = 'Habitat', Duration = '20 min' },
      { 'Restock', From = 'Habitat' },
    },
    assets = { Habitat = { type = 'Habitat', at = { 0, 12 } } },
  }
  sim:run()
  t:near(sim:event('A/20').end_s - sim:event('A/20').start_s, '20 min', '0 s')
  t:near(sim:notes('restocked')[1].fields.added, 10, 1e-9)
  t:near(sim.rovers.A:resource('oxygen'), 24, 0)
  t:equal(sim:event('A/30').status, 'completed')
  t:equal(sim:notes('warning')[1].fields.text,
    'oxygen: as much as at the start is there already')
end)

lsos.scenario('Recharge sets a level at once, and charges until there is enough', function(t)
  local sim = lsos.sim {
    rovers = rover({
      { 'Recharge', EnergyLevel = '50%' },
      { 'Recharge', EnergyRate = '20 kW', UntilCharge = 0.6 },
    }, { charge = 0.1 }),
  }
  sim:run_until(function(s) return s:event('A/10').status == 'completed' end)
  t:near(sim.rovers.A.battery.charge, 0.5, 1e-3)
  sim:run()
  t:near(sim.rovers.A.battery.charge, 0.6, 1e-3)
end)
