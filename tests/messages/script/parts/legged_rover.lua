-- Four limbs of two joints, steered wheels, posture control.
local lsos = require 'lsos'
local vec = lsos.vec3

local motor = {
  rate_max_radps = 0.2, torque_max_n_m = 1000, stiffness_n_m_prad = 1e4, damping_n_m_sprad = 200,
  brake_torque_max_n_m = 1500, efficiency = 0.5,
}
local wheel = {
  radius_m = 0.3, width_m = 0.2, mass_kg = 15, normal_stiffness_npm = 2e4,
  normal_damping_nspm = 300, tangential_damping_nspm = 100,
}
local drive = {
  torque_max_n_m = 100, power_max_w = 200, efficiency = 0.5, servo_gain_n_m_sprad = 40,
  servo_integral_n_m_prad = 40, brake_torque_max_n_m = 200, brake_stiffness_n_m_prad = 3000,
  brake_damping_n_m_sprad = 20,
}
local steering = {
  angle_max_rad = 3, rate_max_radps = 0.5, torque_max_n_m = 200, stiffness_n_m_prad = 2000,
  damping_n_m_sprad = 30,
}
local chassis = {
  mass_kg = 200, size_m = vec(1, 1, 0.3), clearance_m = 0.6, center_of_mass_m = vec(0, 0, 0.75),
}
local posture = { leveling_1ps = 2, load_sharing_mps_pn = 5e-4 }
local limbs = {}
for i, at in ipairs { vec(1, 1, 0), vec(1, -1, 0), vec(-1, 1, 0), vec(-1, -1, 0) } do
  local aside = vec(-at.y, at.x, 0)
  limbs[i] = {
    name = 'limb_' .. i, position_m = at,
    joints = {
      { name = 'hip', position_m = vec(at.x * 0.5, at.y * 0.5, 0.8), axis = aside, mass_kg = 10,
        angle_min_rad = -1.5, angle_max_rad = 1.5 },
      { name = 'knee', position_m = vec(at.x * 0.9, at.y * 0.9, 1.2), axis = aside, mass_kg = 8,
        angle_min_rad = -1.5, angle_max_rad = 1.5 },
    },
  }
end
local suspension = { knuckle_mass_kg = 5 }
local rover = {
  api = 1, doc = 'A rover.', step_s = 0.005, cruise_speed_mps = 0.2, speed_max_mps = 0.3,
  acceleration_mps2 = 0.1, can_turn_on_spot = true,
}

local function whole()
  suspension.limbs = {}
  for i, limb in ipairs(limbs) do
    for j, joint in ipairs(limb.joints) do
      joint.motor = lsos.limb_motor(motor)
      limb.joints[j] = lsos.joint(joint)
    end
    suspension.limbs[i] = lsos.limb(limb)
  end
  suspension.posture = lsos.posture(posture)
  suspension.wheel = lsos.wheel(wheel)
  suspension.drive = lsos.drive(drive)
  suspension.steering = lsos.steering(steering)
  rover.chassis = lsos.chassis(chassis)
  rover.suspension = lsos.legged(suspension)
  return rover
end
