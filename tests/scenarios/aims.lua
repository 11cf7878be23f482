-- An event that has missed its aim does not complete, and what is done in vain is said.

local lsos = require 'lsos'

-- High Sun: the middle of the Moon's near side at its noon.
local noon = '2026-07-29T14:00:00Z'

local function sim_of(events, more)
  local plan = { start = noon, rovers = { A = { type = 'SEV', charge = 0.5, events = events } } }
  for key, value in pairs(more or {}) do plan[key] = value end
  return lsos.sim(plan)
end

local function warned(sim) return #sim:notes('warning') end

lsos.scenario('a recharge whose duration ends below its charge fails', function(t)
  local sim = sim_of {
    { 'StowSP', Duration = 0 },
    { 'Recharge', EnergyRate = '3 kW', UntilCharge = 0.8, Duration = 600, OnFailure = 'skip' },
    { 'Recharge', EnergyRate = '3 kW', UntilCharge = 0.5, Duration = 600 },
  }
  sim:run()
  -- 3 kW less the loads, into 40 kWh with 0.96: 1.2 % at most in ten minutes.
  local charge = tonumber(sim:event('A/20').reason:match('charge is ([%d.]+), UntilCharge is 0.8$'))
  t:near(charge, 0.506, 0.006, sim:event('A/20').reason)
  t:equal(sim:event('A/20').status, 'failed')
  t:equal(sim:event('A/30').status, 'completed')
end)

lsos.scenario('a panel that stops at its limit fails, with the angles', function(t)
  local sim = sim_of {
    { 'SteerSP', Mode = 'point', Azimuth = 0, Elevation = -90, OnFailure = 'skip' },
    { 'SteerSP', Mode = 'point', Azimuth = 120, Elevation = 40 },
    { 'SteerSP', Mode = 'fixed', Azimuth = 350, Elevation = 10 },
  }
  sim:run()
  local reason = sim:event('A/10').reason
  t:equal(sim:event('A/10').status, 'failed')
  local asked = 'was asked for azimuth 0 deg, elevation -90 deg and stopped at'
  t:check(reason:find(asked, 1, true), reason)
  t:near(tonumber(reason:match('elevation ([%d.e-]+) deg$')), 0, 0.5, reason)
  t:equal(sim:event('A/20').status, 'completed')
  t:equal(sim:event('A/30').status, 'completed')
end)

lsos.scenario('a panel that is turned away from the Sun says so', function(t)
  local sim = lsos.sim {
    start = '2026-07-25T00:00:00Z',  -- the Sun in the east
    rovers = { A = { type = 'SEV', heading_deg = 0, events = {
      { 'SteerSP', Mode = 'point', Azimuth = 270, Elevation = 10 },
      { 'SteerSP', Mode = 'point', Azimuth = 90, Elevation = 10 },
      { 'SteerSP', Mode = 'fixed', Azimuth = -90, Elevation = 10 },
    } } },
  }
  sim:run()
  t:equal(#sim:notes('warning'), 2)
  local text = sim:notes('warning')[1].fields.text
  t:check(text:find('it faces away from the Sun, which stands at azimuth ', 1, true), text)
end)

lsos.scenario('a recharge by a Sun that is down says so', function(t)
  local sim = sim_of({
    { 'Recharge', UntilCharge = 0.9, Timeout = 600 },
  }, { start = '2026-07-15T00:00:00Z' })
  sim:run()
  local text = sim:notes('warning')[1].fields.text
  t:check(text:find('no sunlight reaches it now: the Sun is ', 1, true), text)
end)

lsos.scenario('a rendezvous with what is near already says that it does nothing', function(t)
  local sim = lsos.sim {
    rovers = {
      A = { type = 'SEV', events = { { 'Rendezvous', With = 'B', Distance = 2000 } } },
      B = { type = 'SEV', at = { 200, 0 }, events = { { 'Pause', Duration = 10 } } },
    },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  local text = sim:notes('warning')[1].fields.text
  t:check(text:find("it does nothing: 'B' is 200 m away, and Distance is 2000 m", 1, true), text)
end)

lsos.scenario('what is up already is not raised, and that is said', function(t)
  local sim = sim_of {
    { 'DeploySP' }, { 'StowSP' }, { 'StowSP', Panel = 'Roof' }, { 'StowCA' }, { 'DeployCA' },
  }
  sim:run()
  t:equal(warned(sim), 3)
  t:equal(sim:notes('warning')[1].fields.text, 'all are up already: nothing was done')
  t:equal(sim:notes('warning')[2].fields.text, "'Roof' is stowed already: nothing was done")
end)

lsos.scenario('a moment that is over when its turn comes is said, and not waited for', function(t)
  local sim = sim_of {
    { 'Pause', Duration = 600 }, { 'Wait', Until = '2026-07-29T14:05:00Z' },
    { 'Wait', Until = '2026-07-29T14:20:00Z' },
  }
  sim:run()
  t:equal(sim:event('A/20').status, 'completed')
  t:equal(sim:event('A/20').end_s, 600.0)
  t:equal(warned(sim), 1)
  t:equal(sim:notes('warning')[1].fields.text, 'Until was over 300 s before its turn came')
end)

lsos.scenario('tracking a Sun below the horizon is said', function(t)
  local sim = sim_of({ { 'SteerSP' } }, { start = '2026-07-15T00:00:00Z' })
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:check(sim:notes('warning')[1].fields.text:find('below the horizon', 1, true))
end)

lsos.scenario('power from outside that falls short is said once an event', function(t)
  local sim = sim_of({
    { 'Recharge', From = 'Home', EnergyRate = '9 kW', Duration = 100 },
    { 'Recharge', From = 'Home', EnergyRate = '2 kW', Duration = 100 },
    { 'Recharge', From = 'Home', Duration = 100 },
  }, { assets = { Home = { type = 'Habitat', at = { 12, 0 } } } })
  sim:run()
  local short = sim:notes('supply_short')
  t:equal(#short, 1)
  t:equal(short[1].sequence, 10)
  t:equal(short[1].fields.asked_w, 9000)
  t:equal(short[1].fields.given_w, 5000)
end)

lsos.scenario('a recharge that can come to nothing fails, and what it lowers is said', function(t)
  local sim = sim_of {
    { 'StowSP', Duration = 0 },
    { 'Recharge', UntilCharge = 0.9, OnFailure = 'skip' },
    { 'Recharge', EnergyLevel = '5' },
    { 'Recharge', EnergyLevel = '80%', UntilCharge = 0.5, EnergyRate = 100 },
  }
  sim:run()
  t:equal(sim:event('A/20').reason,
    'no panel is up, and UntilCharge without EnergyRate or From waits for the Sun')
  t:equal(sim:event('A/30').status, 'completed')
  local texts = {}
  for _, note in ipairs(sim:notes('warning')) do texts[#texts + 1] = note.fields.text end
  t:check(texts[1]:find("EnergyLevel = '5' lowers what the battery holds from", 1, true), texts[1])
  t:equal(texts[2], 'EnergyLevel set the charge to 0.8 at once, UntilCharge is 0.5: nothing flowed')
end)

lsos.scenario('a drive that is stopped within its arrival radius has arrived', function(t)
  local sim = lsos.sim {
    rovers = { A = { type = 'SEV', at = { 0, 60 }, heading_deg = 180,
      events = { { 'Route', at = { 0, 0 }, ArrivalRadius = 20 } } } },
    assets = { Hab = { type = 'Habitat', at = { 0, 0 } } },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:check(sim:notes('warning')[1].fields.text:find('it stopped within ArrivalRadius', 1, true))
end)

lsos.scenario('what a mission that ends too early waited for', function(t)
  local sim = lsos.sim {
    start = noon, max_duration_s = 600,
    rovers = {
      A = { type = 'SEV', events = { { 'Pause', Duration = 10, StartWhen = 'distance_m > 9' },
        { 'Pause', Duration = 10 } } },
      B = { type = 'SEV', at = { 40, 0 },
        events = { { 'Pause', Duration = 10, StartAfter = 'A/10' } } },
      C = { type = 'SEV', at = { 80, 0 }, charge = 0.5,
        events = { { 'Recharge', UntilCharge = 0.9 } } },
      D = { type = 'SEV', at = { 120, 0 },
        events = { { 'Rendezvous', With = 'Mast', Speed = 0.1 } } },
      E = { type = 'SEV', at = { 160, 60 },
        events = { { 'Pause', Duration = 10, StartTime = '2026-07-29T18:00:00Z' } } },
    },
    assets = { Mast = { type = 'CommStation', at = { 400, 0 } } },
  }
  sim:run()
  local function says(event, text)
    local reason = sim:event(event).reason
    t:check(reason:find(text, 1, true), event .. ': ' .. reason)
  end
  says('A/10', 'it waited for StartWhen: distance_m > 9, which did not hold; distance_m was 0')
  says('A/20', "its turn did not come, 'Pause 10' waited to start")
  says('B/10', 'it waited for StartAfter: A/10 waits itself')
  says('C/10', "in phase 'charge' since 0 s; charge was 0.")
  says('C/10', 'UntilCharge is 0.9')
  says('D/10', "'Mast' was 2")
  says('D/10', 'm away, Distance is 20 m')
  says('E/10', 'it waited for StartTime: 2026-07-29T18:00:00.000Z')
  t:equal(sim:event('A/10').status, 'not_started')
  t:equal(sim:event('C/10').status, 'incomplete')
end)

lsos.scenario('a battery that is emptier after a Recharge is said', function(t)
  local sim = lsos.sim {
    start = noon,
    rovers = { A = { type = 'SEV', charge = 0.5,
      events = { { 'StowSP' }, { 'Recharge', Duration = '1 h' },
        { 'Recharge', Duration = '1 h', EnergyRate = '2 kW' } } } },
  }
  sim:run()
  t:equal(#sim:notes('warning'), 2)
  t:equal(sim:notes('warning')[1].fields.text, 'no panel is up: nothing comes in')
  local text = sim:notes('warning')[2].fields.text
  t:check(text:find('more was used than came in', 1, true), text)
  t:check(text:find('the battery held', 1, true), text)
end)
