-- Panels and antennas, and what happens when they fail.

local lsos = require 'lsos'

-- High Sun: the middle of the Moon's near side at its noon.
local noon = '2026-07-29T14:00:00Z'

local function sim_of(events)
  return lsos.sim { start = noon, rovers = { A = { type = 'SEV', charge = 0.5, events = events } } }
end

lsos.scenario('DeploySP and StowSP put panels up and down', function(t)
  local sim = sim_of {
    { 'StowSP' }, { 'Pause', Duration = 600 }, { 'DeploySP' }, { 'Pause', Duration = 600 },
  }
  sim:run_until(function(s) return s:event('A/20').status == 'completed' end)
  t:near(sim.rovers.A.battery.solar_w, '0 W', '0 W', 'stowed')
  sim:run()
  t:check(sim.rovers.A.battery.solar_w > 100, 'deployed')
end)

lsos.scenario('a panel that is stuck fails what moves it', function(t)
  local sim = sim_of { { 'Pause', Duration = 60 }, { 'StowSP', OnFailure = 'skip' } }
  sim:run_for(10)
  sim:stick_panel('A')
  sim:run()
  t:equal(sim:event('A/20').status, 'failed')
  t:check(sim:event('A/20').reason:find('is stuck', 1, true), sim:event('A/20').reason)
end)

lsos.scenario('shade takes sunlight from the panels', function(t)
  local sim = sim_of { { 'Pause', Duration = '1 h' } }
  sim:run_for(60)
  local clear_w = sim.rovers.A.battery.solar_w
  sim:shade('A', 0.5)
  sim:run_for(60)
  t:near(sim.rovers.A.battery.solar_w, clear_w / 2, 0.01 * clear_w)
  sim:shade('A', 0)
  sim:run_for(60)
  t:near(sim.rovers.A.battery.solar_w, 0, 0)
end)

lsos.scenario('SteerSP turns a panel', function(t)
  local sim = sim_of { { 'SteerSP', Mode = 'track' }, { 'Pause', Duration = 60 } }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
end)

lsos.scenario('DeployCA raises the antenna and StowCA lowers it', function(t)
  local sim = lsos.sim {
    start  = noon,
    rovers = {
      A = {
        type   = 'SEV',
        events = {
          { 'DeployCA' }, { 'Pause', Duration = 60, label = 'up' },
          { 'StowCA' }, { 'Pause', Duration = 60, label = 'down' },
        },
      },
    },
    assets = { Station = { type = 'CommStation', at = { 200, 0 } } },
  }
  sim:run_until(function(s) return s:event('up').status == 'running' end)
  sim:run_for(30)
  t:equal(sim.rovers.A:is_linked_to('Station'), true)
  t:equal(sim.rovers.A:is_linked_to('Earth'), true)
  sim:silence('A')
  sim:run_for(1)
  t:equal(sim.rovers.A:is_linked_to('Station'), false, 'a radio that has failed')
  t:equal(sim.rovers.A:sees('Station'), true, 'on a mast that stands')
  sim:silence('A', false)
  sim:run()
  t:equal(sim:event('A/30').status, 'completed')
end)
