-- Six wheels on rockers and bogies, the four at the corners steered.
local lsos = require 'lsos'

local wheel = {
  radius_m = 0.15, width_m = 0.1, mass_kg = 2, normal_stiffness_npm = 2e4,
  normal_damping_nspm = 300, tangential_damping_nspm = 100,
}
local drive = {
  torque_max_n_m = 30, power_max_w = 50, efficiency = 0.5, servo_gain_n_m_sprad = 2,
  servo_integral_n_m_prad = 10, brake_torque_max_n_m = 40, brake_stiffness_n_m_prad = 300,
  brake_damping_n_m_sprad = 2,
}
local chassis = {
  mass_kg = 120, size_m = lsos.vec3(0.8, 0.4, 0.4), clearance_m = 0.3,
  center_of_mass_m = lsos.vec3(0, 0, 0.5),
}
local front = { name = 'front', position_m = lsos.vec3(0.5, 0.5, 0), is_steered = true }
local middle = { name = 'middle', position_m = lsos.vec3(0, 0.5, 0), on = 'bogie' }
local rear = {
  name = 'rear', position_m = lsos.vec3(-0.5, 0.5, 0), on = 'bogie', is_steered = true,
}
local rocker = {
  pivot_m = lsos.vec3(0.1, 0.4, 0.4), mass_kg = 4, angle_max_rad = 0.6,
  stop_stiffness_n_m_prad = 500, stop_damping_n_m_sprad = 20,
}
local bogie = {
  pivot_m = lsos.vec3(-0.25, 0.4, 0.25), mass_kg = 4, angle_max_rad = 0.6,
  stop_stiffness_n_m_prad = 500, stop_damping_n_m_sprad = 20,
}
local differential = {
  kind = 'bar', position_m = lsos.vec3(0, 0, 0.6), mass_kg = 3, stiffness_n_m_prad = 3000,
  damping_n_m_sprad = 40,
}
local steering = {
  angle_max_rad = 1.2, rate_max_radps = 0.3, torque_max_n_m = 40, stiffness_n_m_prad = 200,
  damping_n_m_sprad = 2,
}
local suspension = { knuckle_mass_kg = 2 }
local rover = {
  api = 1, doc = 'A rover.', step_s = 0.005, cruise_speed_mps = 0.2, speed_max_mps = 0.3,
  acceleration_mps2 = 0.1,
}

local function whole()
  suspension.stations = { lsos.station(front), lsos.station(middle), lsos.station(rear) }
  suspension.rocker = lsos.rocker(rocker)
  suspension.bogie = bogie and lsos.bogie(bogie)
  suspension.differential = lsos.differential(differential)
  suspension.steering = lsos.steering(steering)
  suspension.wheel = lsos.wheel(wheel)
  suspension.drive = lsos.drive(drive)
  rover.chassis = lsos.chassis(chassis)
  rover.suspension = lsos.rocker_bogie(suspension)
  return rover
end
