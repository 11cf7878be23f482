-- What plans/lunar_traverse.kml is there to show, in the order in which it happens.

local lsos = require 'lsos'

-- To the moment at which an event begins, and so long beyond.
local function go_to(sim, label, beyond_s)
  sim:run_until(function(s) return s:event(label).status == 'running' end)
  sim:run_for(beyond_s or 0)
end

-- Of a rover that stands: what its panels give, and what flows into its battery.
local function check_flows(t, battery, what)
  t:equal(battery.external_w, 0, what .. ': it is not plugged in')
  local loss_w = battery.solar_w - battery.load_w - battery.energy_rate_w
  t:check(loss_w >= 0 and loss_w < 0.05 * (battery.solar_w + battery.load_w), what .. ': losses')
end

-- Calls `check` with the rover in each of so many minutes from the beginning of an event.
local function each_minute(sim, label, minutes, check)
  go_to(sim, label)
  for _ = 1, minutes do
    sim:run_for(60)
    check(sim.rovers.SEV1)
  end
end

local function stop_in_the_sun(t, sim, label, minutes)
  each_minute(sim, label, minutes, function(rover)
    t:check(rover.panels.sun_fraction > 0.7, label .. ': the Sun is on the panel')
    t:check(rover.battery.energy_rate_w > 1000, label .. ': the battery is charged')
    check_flows(t, rover.battery, label)
  end)
end

local function stop_in_the_shadow(t, sim, label, minutes)
  each_minute(sim, label, minutes, function(rover)
    t:equal(rover.panels.sun_fraction, 0, label .. ': no Sun on the panel')
    t:equal(rover.battery.solar_w, 0, label .. ': no power of it')
    -- 550 W of cabin and radio, 300 W of heaters in the dark, by a battery that gives 0.96 of it.
    t:near(rover.battery.energy_rate_w, -850 / 0.96, '1 mW', label .. ': the static power draw')
  end)
end

lsos.scenario('the lunar traverse is as its plan means it', function(t)
  local sim = lsos.sim('plans/lunar_traverse.kml')
  local rover = sim.rovers.SEV1

  go_to(sim, 'Away from base', 120)
  t:check(rover:sees('Base') and rover:sees('Earth'), 'the habitat and Earth are in sight')
  t:check(rover.slip > 0, 'wheels slip')

  stop_in_the_sun(t, sim, 'Stop 1', 40)
  t:check(rover:is_linked_to('Earth'), 'with the mast up there is a link to Earth')

  go_to(sim, 'Into the crater')
  t:check(rover:sees('Earth') and not rover:is_linked_to('Earth'), 'with the mast down none')
  stop_in_the_shadow(t, sim, 'Stop 2', 45)
  t:check(not rover:sees('Base') and not rover:sees('Earth'), 'the crater hides both')

  stop_in_the_shadow(t, sim, 'Stop 3', 45)
  stop_in_the_sun(t, sim, 'Stop 4', 50)

  go_to(sim, 'Home', 60)
  t:check(rover:sees('Base') and rover:sees('Earth'), 'both are in sight again')
  sim:run()
  for _, event in ipairs(sim.events) do t:equal(event.status, 'completed', event.label) end
  local habitat = rover:place_of('Base')
  t:near((rover.position - lsos.vec3(30, -10, 0)):length(), '0 m', '1.1 m', 'from where it ends')
  t:check(rover:distance_to_m(habitat) < 100, 'it is home')
  t:near(sim.time_s, '5 h', '10 min', 'the mission takes')
  t:near(rover.distance_m, '2.9 km', '0.1 km', 'driven')
end)
