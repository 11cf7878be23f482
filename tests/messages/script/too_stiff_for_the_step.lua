-- expect: too_stiff_for_the_step.lua:70: rover: step_s = 0.005: too long for the wheel's normal spring of front_left_wheel_1
-- as: rovers
local lsos = require 'lsos'
local payload_kg   = 1000
local total_kg     = 3000 + payload_kg
local wheelbase_m  = 4.0
local track_m      = 3.0
local arm_kg       = 40                  -- A
local knuckle_kg   = 40
local wheel_kg     = 30                  -- A

local modules = {}
for axle, x_m in ipairs { wheelbase_m / 2, 0, -wheelbase_m / 2 } do
  for side, y_m in ipairs { track_m / 2, -track_m / 2 } do
    modules[#modules + 1] = lsos.module {
      name       = ({ 'front', 'middle', 'rear' })[axle] .. ({ '_left', '_right' })[side],
      position_m = lsos.vec3(x_m, y_m, 0),
    }
  end
end

local chassis = lsos.chassis {
  mass_kg          = total_kg - #modules * (arm_kg + knuckle_kg + 2 * wheel_kg),
  size_m           = lsos.vec3(4.5, 2.0, 2.4),
  clearance_m      = 0.6,
  center_of_mass_m = lsos.vec3(0, 0, 1.3),
}

local suspension = lsos.wishbone {
  modules         = modules,
  arm_mass_kg     = arm_kg,
  knuckle_mass_kg = knuckle_kg,
  spring = lsos.spring {
    stiffness_npm = 1e4,
    damping_nspm  = 3200,
    travel_up_m   = 0.25,
    travel_down_m = 0.25,
  },

  steering = lsos.steering {
    angle_max_rad      = math.pi,
    rate_max_radps     = 0.5,        -- A
    torque_max_n_m     = 2000,
    stiffness_n_m_prad = 2e4,        -- A
    damping_n_m_sprad  = 600,
  },

  wheel_offsets_m = { 0.2, -0.2 },
  wheel = lsos.wheel {
    radius_m                = 0.495,
    width_m                 = 0.305,
    mass_kg                 = wheel_kg,
    normal_stiffness_npm    = 1e8,
    normal_damping_nspm     = 2500,    -- A
    tangential_damping_nspm = 500,     -- A
  },

  drive = lsos.drive {
    torque_max_n_m           = 730,
    power_max_w              = 1500,   -- A
    efficiency               = 0.8,
    servo_gain_n_m_sprad     = 300,
    servo_integral_n_m_prad  = 300,
    brake_torque_max_n_m     = 1500,
    brake_stiffness_n_m_prad = 2e4,
    brake_damping_n_m_sprad  = 200,
  },
}

return lsos.rover {
  api  = 1,
  doc  = 'Pressurised rover for two, twelve wheels in six steerable modules.',

  chassis    = chassis,
  suspension = suspension,

  step_s            = 0.005,
  cruise_speed_mps  = 2.0,
  speed_max_mps     = 2.78,
  acceleration_mps2 = 0.3,    -- A
  can_turn_on_spot  = true,

}
