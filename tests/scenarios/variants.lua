-- Rovers of one type whose plan changes some of their numbers.

local lsos = require 'lsos'

lsos.scenario('two rovers of a type may differ in a number', function(t)
  local wait = { 'Pause', Duration = '1 h' }
  local sim = lsos.sim {
    terrain = 'Flat',
    rovers  = {
      A = { type = 'SEV', charge = 0.5, events = { wait } },
      B = {
        type   = 'SEV', at = { 30, 0 }, charge = 0.5, events = { wait },
        variant = 'battery.capacity_j = 80 kWh; loads.cabin.power_w = 1 kW',
      },
    },
  }
  sim:run()
  t:near(sim.rovers.A.battery.capacity_j, '40 kWh', '1 J')
  t:near(sim.rovers.B.battery.capacity_j, '80 kWh', '1 J')
  -- An hour of 500 W more; the battery loses up to 4 % on the way in or out.
  local more_kwh = (sim:event('B/10').energy_used_j - sim:event('A/10').energy_used_j) / 3.6e6
  t:check(more_kwh > 0.475 and more_kwh < 0.525, ('the cabin takes %.3f kWh more'):format(more_kwh))
end)

lsos.scenario('a heavier rover uses more energy on the same drive', function(t)
  local function used_j(variant)
    local sim = lsos.sim {
      terrain = 'Slope',
      rovers  = {
        A = { type = 'SEV', variant = variant, events = { { 'Route', at = { 0, 60 } } } },
      },
    }
    sim:run()
    t:equal(sim:event('A/10').status, 'completed')
    return sim:event('A/10').energy_used_j
  end
  t:check(used_j 'chassis.mass_kg = 4000' > used_j(nil), 'of 840 kg more')
end)
