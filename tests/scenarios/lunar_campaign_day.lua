-- What plans/lunar_campaign_day.kml is there to show: the first day of four weeks at the pole.

local lsos = require 'lsos'

local function go_to(sim, label, beyond_s)
  sim:run_until(function(s) return s:event(label).status == 'running' end)
  sim:run_for(beyond_s or 0)
end

lsos.scenario('a day of the lunar campaign is as its plan means it', function(t)
  local sim = lsos.sim('plans/lunar_campaign_day.kml')
  local a, b, athlete = sim.rovers.SEV_A, sim.rovers.SEV_B, sim.rovers.ATHLETE

  for id, rover in pairs(sim.rovers) do
    t:check(not rover:sees('Earth'), 'Earth is below the horizon for ' .. id)
    t:check(rover:sky().sun_elevation_rad < math.rad(2), 'the Sun is low')
  end

  go_to(sim, 'To A1 site', 600)
  t:check(a.speed_mps > 0.5, 'A drives')
  t:equal(a.battery.solar_w, 0, 'with its panel down nothing comes from the Sun')
  t:check(a.battery.energy_rate_w < -1000, 'and the battery pays for it')

  go_to(sim, 'To T1', 120)
  t:check(athlete.speed_mps > 0, 'ATHLETE drives')
  t:check(athlete.battery.solar_w > 100, 'with its panel after the Sun')

  go_to(sim, 'A1 EVA', 600)
  t:equal(a.speed_mps, 0, 'A stands for the EVA')

  go_to(sim, 'Mast up, A1 camp', 60)
  for id, rover in pairs { SEV_A = a, SEV_B = b } do
    t:check(rover.panels.sun_fraction > 0.9, id .. ' camps where the Sun shines')
    t:check(rover.battery.energy_rate_w > 1000, id .. ' is charged there')
    t:check(rover.distance_m > 4000, id .. ' has driven kilometres')
  end
  sim:run()
  for _, event in ipairs(sim.events) do t:equal(event.status, 'completed', event.label) end
  for id, rover in pairs(sim.rovers) do
    t:check(rover.battery.charge > 0.7, id .. ' has a charge to go on with')
  end
end)
