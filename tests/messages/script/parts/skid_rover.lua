-- Four wheels that do not steer, straight on the body.
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
local front = { name = 'front', position_m = lsos.vec3(0.5, 0.5, 0) }
local rear = { name = 'rear', position_m = lsos.vec3(-0.5, 0.5, 0) }
local stations = { front, rear }
local suspension = { turning_track_ratio = 1.5 }
local rover = {
  api = 1, doc = 'A rover.', step_s = 0.005, cruise_speed_mps = 0.2, speed_max_mps = 0.3,
  acceleration_mps2 = 0.1,
}

local function whole()
  suspension.stations = {}
  for i, station in ipairs(stations) do suspension.stations[i] = lsos.station(station) end
  suspension.wheel = lsos.wheel(wheel)
  suspension.drive = lsos.drive(drive)
  rover.chassis = lsos.chassis(chassis)
  rover.suspension = lsos.skid_steer(suspension)
  return rover
end
