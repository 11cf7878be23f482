-- Twelve wheels in six sprung and steered modules of two.
local lsos = require 'lsos'

local modules = {
  { name = 'front_left', position_m = lsos.vec3(2, 1.5, 0) },
  { name = 'front_right', position_m = lsos.vec3(2, -1.5, 0) },
  { name = 'middle_left', position_m = lsos.vec3(0, 1.5, 0) },
  { name = 'middle_right', position_m = lsos.vec3(0, -1.5, 0) },
  { name = 'rear_left', position_m = lsos.vec3(-2, 1.5, 0) },
  { name = 'rear_right', position_m = lsos.vec3(-2, -1.5, 0) },
}
local wheel = {
  radius_m = 0.495, width_m = 0.305, mass_kg = 30, normal_stiffness_npm = 1e5,
  normal_damping_nspm = 2500, tangential_damping_nspm = 500,
}
local drive = {
  torque_max_n_m = 730, power_max_w = 1500, efficiency = 0.8, servo_gain_n_m_sprad = 300,
  servo_integral_n_m_prad = 300, brake_torque_max_n_m = 1500, brake_stiffness_n_m_prad = 2e4,
  brake_damping_n_m_sprad = 200,
}
local chassis = {
  mass_kg = 3160, size_m = lsos.vec3(4.5, 2.0, 2.4), clearance_m = 0.6,
  center_of_mass_m = lsos.vec3(0, 0, 1.3),
}
local spring = { stiffness_npm = 1e4, damping_nspm = 3200, travel_up_m = 0.25, travel_down_m = 0.25 }
local steering = {
  angle_max_rad = math.pi, rate_max_radps = 0.5, torque_max_n_m = 2000, stiffness_n_m_prad = 2e4,
  damping_n_m_sprad = 600,
}
local suspension = { arm_mass_kg = 40, knuckle_mass_kg = 40, wheel_offsets_m = { 0.2, -0.2 } }
local rover = {
  api = 1, doc = 'A rover.', step_s = 0.005, cruise_speed_mps = 2.0, speed_max_mps = 2.78,
  acceleration_mps2 = 0.3, can_turn_on_spot = true,
}

local function whole()
  suspension.modules = {}
  for i, module in ipairs(modules) do suspension.modules[i] = lsos.module(module) end
  suspension.spring = lsos.spring(spring)
  suspension.steering = lsos.steering(steering)
  suspension.wheel = lsos.wheel(wheel)
  suspension.drive = lsos.drive(drive)
  rover.chassis = lsos.chassis(chassis)
  rover.suspension = lsos.wishbone(suspension)
  return rover
end
