-- What plans/drats_day.kml is there to show: A above the ridge, B below it.

local lsos = require 'lsos'

local function go_to(sim, label, beyond_s)
  sim:run_until(function(s) return s:event(label).status == 'running' end)
  sim:run_for(beyond_s or 0)
end

lsos.scenario('a day in Arizona is as its plan means it', function(t)
  local sim = lsos.sim('plans/drats_day.kml')
  local a, b = sim.rovers.A, sim.rovers.B

  sim:run_for(2)
  t:check((a.position - b.position):length() < 50, 'they begin side by side')

  go_to(sim, 'EVA, A1 stop 1', 60)
  t:check(a:is_linked_to('Base'), 'from the flow, with the mast up, A reaches the base')
  t:check(not a:sees('B') and not b:sees('A'), 'the ridge stands between the two')

  go_to(sim, 'Short EVA, A1 camp', 60)
  t:check(a.distance_m > 3000 and b.distance_m > 3000, 'kilometres are driven')
  t:check(a.elevation_m > b.elevation_m + 10, 'A works above, B below')

  go_to(sim, 'Night 1: from the support trailer', 60)
  t:check(sim.time_s >= 10 * 3600, 'the night begins in the evening')
  sim:run_for('2 h')
  for id, rover in pairs(sim.rovers) do
    t:equal(rover.battery.solar_w, 0, 'no Sun at night for ' .. id)
    t:check(rover.battery.external_w > 400, 'the trailer keeps the cabin of ' .. id)
  end
  sim:run()
  for _, event in ipairs(sim.events) do t:equal(event.status, 'completed', event.label) end
  for id, rover in pairs(sim.rovers) do
    t:check(rover.battery.charge >= 0.95, id .. ' is charged for the next day')
  end
end)
