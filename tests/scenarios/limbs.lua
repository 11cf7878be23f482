-- Rovers on limbs: stances, and what they are good for.

local lsos = require 'lsos'

local function sim_of(events, more)
  local rover = { type = 'ATHLETE', events = events }
  local plan = { terrain = 'Flat', rovers = { A = rover } }
  for key, value in pairs(more or {}) do
    if key == 'config' then rover.config = value else plan[key] = value end
  end
  return lsos.sim(plan)
end

lsos.scenario('SetPosture changes the stance and back', function(t)
  local sim = sim_of {
    { 'SetPosture', Stance = 'Tall' },
    { 'SetPosture', Stance = 'Stow', Duration = '60 s' },
    { 'SetPosture', Height = '1.2 m' },
    { 'Route', at = { 0, 10 } },
  }
  sim:run_until(function(s) return s:event('A/10').status == 'completed' end, 100)
  -- Where the limbs really hold it: they give way by some millimetres under its weight.
  t:near(sim.rovers.A.clearance_m, '1.9 m', '2 cm')
  t:equal(sim.rovers.A.stance_fault, nil)
  sim:run_until(function(s) return s:event('A/20').status == 'completed' end, 200)
  t:near(sim.rovers.A.clearance_m, '0.3 m', '2 cm')
  local stow = sim:event('A/20')
  t:check(stow.end_s - stow.start_s >= 60, 'as long as Duration says')
  sim:run()
  t:near(sim.rovers.A.clearance_m, '1.2 m', '2 cm')
  t:equal(sim:event('A/40').status, 'completed')
end)

lsos.scenario('SetPosture refuses what its joints cannot do in time', function(t)
  local sim = sim_of { { 'SetPosture', Stance = 'Tall', Duration = '2 s' } }
  sim:run()
  t:equal(sim:event('A/10').status, 'failed')
  local reason = sim:event('A/10').reason
  local wanted = '^limb_%d_knee_pitch needs [%d.]+ s at its greatest rate, Duration is 2 s$'
  t:check(reason:match(wanted) ~= nil, reason)
end)

lsos.scenario('SetPosture fails when a limb breaks while it moves, and names its joint', function(t)
  local sim = sim_of { { 'SetPosture', Stance = 'Tall' } }
  sim:run_for(2)
  sim:fault('A', { what = 'limb', part = 'limb_3' })
  sim:run()
  local stood = sim:event('A/10')
  t:equal(stood.status, 'failed')
  t:check(stood.reason:find('limb_3_hip_yaw is locked', 1, true) ~= nil, stood.reason)
end)

lsos.scenario('a limb that is repaired levels the chassis of a rover that stands', function(t)
  local sim = sim_of({
    { 'Pause', Duration = '20 s' },
    { 'SetPosture', Height = '1.5 m', OnFailure = 'skip' },
    { 'Pause', Duration = '10 min' },
  }, { terrain = 'Slope' })
  sim:run_for(22)
  sim:fault('A', { what = 'limb', part = 'limb_3' })
  sim:run_until(function(s) return s:event('A/30').status == 'running' end, 200)
  sim:run_for('1 min')
  t:check(sim.rovers.A.is_parked, 'it rests')
  sim:fault('A', { what = 'limb', part = 'limb_3', is_repair = true })
  sim:run_for('2 min')
  t:check(sim.rovers.A.is_parked, 'it rests again')
  t:near(sim.rovers.A.clearance_m, '1.5 m', '3 cm')
  t:equal(sim.rovers.A.stance_fault, nil)
end)

lsos.scenario('a chassis that is lowered onto the ground is noted', function(t)
  local sim = sim_of { { 'SetPosture', Height = '0.01 m' } }
  sim:run()
  t:equal(#sim:notes('chassis_on_ground'), 1)
end)

lsos.scenario('Level keeps it level on a slope, and without it lies on it', function(t)
  local sim = sim_of({
    { 'Pause', Duration = '10 s' },
    { 'SetPosture', Level = 'false' },
    { 'Pause', Duration = '10 s' },
    { 'SetPosture', Level = 'true' },
  }, { terrain = 'Slope' })
  local function tilt_rad()
    local rover = sim.rovers.A
    return math.acos(math.cos(rover.pitch_rad) * math.cos(rover.roll_rad))
  end
  sim:run_for(5)
  t:check(tilt_rad() < math.rad(0.5), 'level at the start')
  sim:run_until(function(s) return s:event('A/30').status == 'running' end, 100)
  t:near(tilt_rad(), sim.rovers.A.slope_rad, math.rad(1), 'as the ground')
  sim:run()
  t:check(tilt_rad() < math.rad(0.5), 'level again')
end)

lsos.scenario('a change of stance costs energy of the drives', function(t)
  local sim = sim_of { { 'SetPosture', Stance = 'Tall' } }
  sim:run()
  -- 298 kg of frame by a metre at 1.62 m/s2 through gears of one half.
  t:check(sim.rovers.A.drive_j > 298 * 1.62 / 0.5, 'more than the lift')
  t:check(sim.rovers.A.drive_j < 2e4, 'but not much more')
end)

lsos.scenario('a rover on wheels has no posture', function(t)
  local sim = lsos.sim { rovers = { B = { type = 'SEV', events = { { 'Pause', Duration = 1 } } } } }
  t:fails(function() sim:dispatch('B', 'SetPosture', { Stance = 'Tall' }) end,
    'SEV has no limbs: it cannot change its posture')
end)
