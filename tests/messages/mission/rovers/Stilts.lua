-- Four limbs of two joints without posture control: it lies as the ground does.
local lsos = require 'lsos'
local vec = lsos.vec3

local motor = lsos.limb_motor {
  rate_max_radps = 0.2, torque_max_n_m = 1000, stiffness_n_m_prad = 1e4, damping_n_m_sprad = 200,
  brake_torque_max_n_m = 1500, efficiency = 0.5,
}
local limbs = {}
for i, at in ipairs { vec(1, 1, 0), vec(1, -1, 0), vec(-1, 1, 0), vec(-1, -1, 0) } do
  local aside = vec(-at.y, at.x, 0)
  local function joint(name, share, height_m, mass_kg)
    return lsos.joint {
      name = name, position_m = vec(at.x * share, at.y * share, height_m), axis = aside,
      mass_kg = mass_kg, angle_min_rad = -1.5, angle_max_rad = 1.5, motor = motor,
    }
  end
  limbs[i] = lsos.limb {
    name = 'limb_' .. i, position_m = at,
    joints = { joint('hip', 0.5, 0.8, 10), joint('knee', 0.9, 1.2, 8) },
  }
end

return lsos.rover {
  api = 1, doc = 'A rover on stiff limbs.',
  chassis = lsos.chassis {
    mass_kg = 200, size_m = vec(1, 1, 0.3), clearance_m = 0.6, center_of_mass_m = vec(0, 0, 0.75),
  },
  suspension = lsos.legged {
    limbs = limbs, knuckle_mass_kg = 5,
    wheel = lsos.wheel {
      radius_m = 0.3, width_m = 0.2, mass_kg = 15, normal_stiffness_npm = 2e4,
      normal_damping_nspm = 300, tangential_damping_nspm = 100,
    },
    drive = lsos.drive {
      torque_max_n_m = 100, power_max_w = 200, efficiency = 0.5, servo_gain_n_m_sprad = 40,
      servo_integral_n_m_prad = 40, brake_torque_max_n_m = 200, brake_stiffness_n_m_prad = 3000,
      brake_damping_n_m_sprad = 20,
    },
    steering = lsos.steering {
      angle_max_rad = 3, rate_max_radps = 0.5, torque_max_n_m = 200, stiffness_n_m_prad = 2000,
      damping_n_m_sprad = 30,
    },
  },
  step_s = 0.005, cruise_speed_mps = 0.2, speed_max_mps = 0.3, acceleration_mps2 = 0.1,
  can_turn_on_spot = true,
}
