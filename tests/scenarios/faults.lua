-- What breaks of a rover, by Fault and by hand, and what is repaired.

local lsos = require 'lsos'

-- High Sun: the middle of the Moon's near side at its noon.
local noon = '2026-07-29T14:00:00Z'

local function sim_of(events, more)
  local plan = {
    start = noon, terrain = 'Flat',
    rovers = { A = { type = 'SEV', charge = 0.5, events = events } },
  }
  for key, value in pairs(more or {}) do plan[key] = value end
  return lsos.sim(plan)
end

lsos.scenario('a wheel that locks on the way drags, and drags no more when repaired', function(t)
  local sim = sim_of {
    { 'Route', at = { 0, 120 } },
    { 'Fault', What = 'wheel', Part = 'front_left_wheel_1', At = '20 s', label = 'seizes' },
    { 'Fault', What = 'wheel', Part = 'front_left_wheel_2', At = '20 s' },
    { 'Fault', What = 'wheel', Repair = 'true', At = '40 s', label = 'repaired' },
  }
  local function drive_jpm(from_s, to_s)
    sim:run_until(function(s) return s.time_s >= from_s end)
    local from_j, from_m = sim.rovers.A.drive_j, sim.rovers.A.distance_m
    sim:run_until(function(s) return s.time_s >= to_s end)
    return (sim.rovers.A.drive_j - from_j) / (sim.rovers.A.distance_m - from_m)
  end
  local sound_jpm, dragging_jpm, repaired_jpm =
    drive_jpm(12, 20), drive_jpm(26, 39), drive_jpm(46, 54)
  t:check(dragging_jpm > 1.1 * sound_jpm, ('%g J/m, %g before'):format(dragging_jpm, sound_jpm))
  t:near(repaired_jpm, sound_jpm, 0.05 * sound_jpm, 'repaired')
  sim:run()
  t:equal(sim:event('A/10').status, 'completed')
  t:near(sim:event('seizes').start_s, 20, 0)
  t:near(sim:event('seizes').end_s, 20, 0)
  t:equal(sim:event('repaired').status, 'completed')
  local faults = sim:notes('fault')
  t:equal(#faults, 3)
  t:equal(faults[1].fields.mode, 'locked')
  t:equal(faults[1].fields.part, 'front_left_wheel_1')
  t:equal(faults[3].fields.repair, true)
end)

lsos.scenario('a wheel that turns freely leaves the work to the others', function(t)
  local sim = sim_of {
    { 'Fault', What = 'wheel', Part = 'rear_right_wheel_1', Mode = 'free' },
    { 'Route', at = { 0, 60 } },
  }
  sim:run()
  t:equal(sim:event('A/10').status, 'completed', 'in its turn')
  t:equal(sim:event('A/20').status, 'completed')
  t:equal(sim:notes('fault')[1].sequence, 10)
end)

lsos.scenario('a wheel set to driven is driven, also one that the configuration locks', function(t)
  local function drive_j(mode)
    local rover = {
      type = 'MER', config = 'RightFrontLocked', events = { { 'Route', at = { 0, 2 } } },
    }
    local sim = lsos.sim { terrain = 'Flat', soil = 'Rock', rovers = { A = rover } }
    if mode == 'driven' then sim:set_wheel('A', 'front_right_wheel', mode) end
    if mode == 'repaired' then
      sim:fault('A', { what = 'wheel', part = 'front_right_wheel', is_repair = true })
    end
    sim:run()
    t:equal(sim:event('A/10').status, 'completed')
    return sim.rovers.A.drive_j
  end
  local locked_j = drive_j()
  t:check(drive_j('driven') < 0.8 * locked_j, 'it drags no more')
  t:near(drive_j('repaired'), locked_j, 0.01 * locked_j, 'a repair restores the configuration')
end)

lsos.scenario('a stuck steering motor keeps its angle, and the rover drives on', function(t)
  local function run(fault)
    local events = { { 'Route', path = { { 0, 0 }, { 0, 40 }, { 40, 40 } } } }
    if fault then
      events[2] = { 'Fault', What = 'steering', Part = 'front_left_steering', At = '10 s' }
    end
    local sim = sim_of(events)
    sim:run()
    return sim
  end
  local sound, stuck = run(false), run(true)
  t:equal(stuck:event('A/10').status, 'completed')
  t:near((stuck.rovers.A.position - lsos.vec3(40, 40, 0)):length(), '0 m', '1.5 m', 'from its goal')
  t:check(stuck.rovers.A.drive_j > 1.02 * sound.rovers.A.drive_j, 'a wheel that cannot steer drags')
end)

lsos.scenario('dead antennas link to nobody until they are repaired', function(t)
  local sim = sim_of({
    { 'DeployCA' }, { 'Pause', Duration = '1 h' },
    { 'Fault', What = 'antenna', At = '10 min' },
    { 'Fault', What = 'antenna', Part = 'Mast', Repair = 'true', At = '20 min' },
  }, { assets = { Station = { type = 'CommStation', at = { 200, 0 } } } })
  sim:run_for('9 min')
  t:equal(sim.rovers.A:is_linked_to('Station'), true)
  sim:run_for('6 min')
  t:equal(sim.rovers.A:is_linked_to('Station'), false, 'dead')
  t:equal(sim.rovers.A:is_linked_to('Earth'), false, 'dead')
  t:equal(sim.rovers.A:sees('Station'), true, 'its mast stands')
  sim:run_for('6 min')
  t:equal(sim.rovers.A:is_linked_to('Station'), true, 'repaired')
end)

lsos.scenario('a battery that loses a share holds no more than what is left', function(t)
  local sim = sim_of {
    { 'Pause', Duration = '10 min' },
    { 'Fault', What = 'battery', Share = '60 %', At = 60 },
    { 'Fault', What = 'battery', Repair = 'true', At = 120 },
  }
  sim:run_for(59)
  local whole_j, before_j = sim.rovers.A.battery.capacity_j, sim.rovers.A.battery.energy_j
  sim:run_for(2)
  local battery = sim.rovers.A.battery
  t:near(battery.capacity_j, 0.4 * whole_j, 1)
  t:near(battery.charge, 1, 1e-3, 'full, as half of it was')
  t:check(before_j - battery.energy_j > 0.09 * whole_j, 'the rest is lost')
  sim:run_for(61)
  t:near(sim.rovers.A.battery.capacity_j, whole_j, 0, 'repaired')
  t:check(sim.rovers.A.battery.charge < 0.45, 'what was lost does not come back')
end)

lsos.scenario('a panel gives power by the share of its area that works', function(t)
  local sim = sim_of {
    { 'Pause', Duration = '1 h' },
    { 'Fault', What = 'panel', Part = 'Roof', Mode = 'dead', Share = 0.25, At = '5 min' },
    { 'Fault', What = 'panel', Mode = 'dead', At = '10 min' },
    { 'Fault', What = 'panel', Repair = 'true', At = '15 min' },
  }
  sim:run_for('4 min')
  local whole_w = sim.rovers.A.battery.solar_w
  t:check(whole_w > 100, 'in the Sun')
  sim:run_for('5 min')
  t:near(sim.rovers.A.battery.solar_w, 0.75 * whole_w, 0.01 * whole_w)
  sim:run_for('5 min')
  t:equal(sim.rovers.A.battery.solar_w, 0.0)
  t:check(sim.rovers.A.panels.sun_fraction > 0.9, 'the Sun falls on it all the same')
  sim:run_for('5 min')
  t:near(sim.rovers.A.battery.solar_w, whole_w, 0.01 * whole_w)
end)

lsos.scenario('a panel that is stuck fails what moves it, until it is repaired', function(t)
  local sim = sim_of {
    { 'Fault', What = 'panel' },
    { 'StowSP', OnFailure = 'skip' },
    { 'Fault', What = 'panel', Mode = 'stuck', Repair = 'true' },
    { 'StowSP' },
  }
  sim:run()
  t:equal(sim:event('A/20').status, 'failed')
  t:check(sim:event('A/20').reason:find('is stuck', 1, true), sim:event('A/20').reason)
  t:equal(sim:event('A/40').status, 'completed')
end)

lsos.scenario('a limb that is locked stays as it is', function(t)
  local sim = lsos.sim {
    terrain = 'Flat',
    rovers  = {
      A = {
        type   = 'ATHLETE',
        events = {
          { 'Fault', What = 'limb', Part = 'limb_1' },
          { 'SetPosture', Stance = 'Tall', OnFailure = 'skip' },
          { 'Fault', What = 'limb', Repair = 'true' },
          { 'SetPosture', Stance = 'Tall' },
        },
      },
    },
  }
  sim:run()
  t:equal(sim:event('A/20').status, 'failed')
  t:check(sim:event('A/20').reason:find('limb_1', 1, true), sim:event('A/20').reason)
  t:equal(sim:event('A/40').status, 'completed')
  t:near(sim.rovers.A.clearance_m, '1.9 m', '0.05 m')
end)

lsos.scenario('Fault with At wakes a parked rover, and others do not wait for it', function(t)
  local sim = sim_of {
    { 'Fault', What = 'antenna', At = '500.05 s', label = 'late' },
    { 'Fault', What = 'panel', Mode = 'dead', At = '2026-07-29T14:01:40Z', label = 'early' },
    { 'Pause', Duration = 600, label = 'rest' },
    { 'Fault', What = 'battery', Share = 1, At = '1 d', label = 'never' },
  }
  sim:run()
  t:equal(sim:event('rest').start_s, 0.0)
  t:near(sim:event('rest').end_s, 600, 0)
  t:near(sim:event('late').start_s, 500.1, 1e-9, 'rounded up to an exchange')
  t:near(sim:event('early').start_s, 100, 1e-9)
  t:equal(sim:event('early').status, 'completed')
  t:equal(sim:event('never').status, 'not_started')
  t:check(sim:event('never').reason:find('the mission was over at 600 s', 1, true),
    sim:event('never').reason)
end)

lsos.scenario('by hand breaks what plans can', function(t)
  local sim = sim_of { { 'Pause', Duration = '1 h' } }
  sim:run_for(60)
  local whole_w = sim.rovers.A.battery.solar_w
  sim:fault('A', { what = 'panel', share = 0.5 })
  sim:run_for(60)
  t:near(sim.rovers.A.battery.solar_w, whole_w / 2, 0.01 * whole_w)
  t:equal(sim:notes('fault')[1].fields.share, 0.5)
  sim:fault('A', { what = 'panel', is_repair = true })
  sim:run_for(60)
  t:near(sim.rovers.A.battery.solar_w, whole_w, 0.01 * whole_w)
  t:fails(function() sim:fault('A', { what = 'limb' }) end, 'the rover has no limb')
  t:fails(function() sim:fault('A', { what = 'wheel', part = 'fifth wheel' }) end,
    "no wheel 'fifth wheel'")
end)

lsos.scenario('a dispatched Fault has a Sequence and waits for no turn', function(t)
  local sim = sim_of { { 'Pause', Duration = 100 }, { 'Pause', Duration = 100 } }
  sim:run_for(120)
  sim:dispatch('A', 'Fault', { What = 'wheel', At = 150 })
  sim:dispatch('A', 'Fault', { What = 'antenna', At = 10 })
  sim:run()
  t:equal(sim:event('A/20').end_s, 200.0)
  t:equal(sim:event('A/21').start_s, 150.0)
  t:near(sim:event('A/22').start_s, 120.1, 1e-9, 'its time was over')
end)

lsos.scenario('a rover with all wheels locked does not arrive, and says so', function(t)
  local sim = sim_of { { 'Route', at = { 0, 100 } }, { 'Fault', What = 'wheel', At = 20 } }
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  t:check(sim:event('A/10').reason:find('stuck', 1, true), sim:event('A/10').reason)
end)
