-- A skid-steer field rover of the class of Clearpath's Husky A200: four lugged rubber tyres
-- straight on the body.
--
-- Each number says where it is from: (V) read in the source, (R) recalled, source not seen,
-- (D) computed from those, (A) our assumption, which summary.json repeats. 'Model' is the
-- maker's husky_description/urdf, 'control' its husky_control/config/control.yaml, 'manual' the
-- A200 user manual of 2011.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local vec = lsos.vec3
local box = drawn.box

local total_kg    = 50      -- R: maker's data sheet
local wheel_kg    = 2.637   -- V: model
local wheelbase_m = 0.512   -- V: model
local track_m     = 0.555   -- V: manual p. 9 (model: 0.5708)
local body_kg     = total_kg - 4 * wheel_kg  -- D: 39.5

local stations = {
  lsos.station { name = 'front', position_m = vec(wheelbase_m / 2, track_m / 2, 0) },
  lsos.station { name = 'rear', position_m = vec(-wheelbase_m / 2, track_m / 2, 0) },
}

local suspension = lsos.skid_steer {
  stations            = stations,
  -- V: wheel_separation_multiplier, control; D: 1 + (wheelbase/track)^2 = 1.85 with even friction
  turning_track_ratio = 1.875,

  wheel = lsos.wheel {
    radius_m                 = 0.165,   -- V: model
    width_m                  = 0.114,   -- V: model
    mass_kg                  = wheel_kg,
    inertia_kgm2             = vec(0.0247, 0.0441, 0.0247),  -- V: model
    normal_stiffness_npm     = 4e4,     -- A: 3 mm under its load on Earth
    normal_damping_nspm      = 400,     -- A
    tangential_damping_nspm  = 100,     -- A
    interface_friction_ratio = 1,       -- A: lugs shear soil on soil
    rolling_resistance       = 0.02,    -- A: flexing of the tyre
  },

  drive = lsos.drive {
    torque_max_n_m           = 50,   -- A: all the grip a wheel has with its payload
    power_max_w              = 100,  -- R: 400 W for four wheels
    no_load_speed_radps      = 9,    -- A: half as much again as at the greatest speed
    efficiency               = 0.7,  -- A: gear and belt
    winding_loss_w_pn2m2     = 0.02, -- A: 8 W at 20 N m, a steep climb
    friction_n_m             = 1,    -- A: gear and belt
    idle_w                   = 3,    -- A: of the controller
    servo_gain_n_m_sprad     = 5,    -- A: 0.6 of what the step allows (D)
    servo_integral_n_m_prad  = 20,   -- A: a lasting load is made up in 0.25 s
    brake_torque_max_n_m     = 60,   -- A
    brake_stiffness_n_m_prad = 800,  -- A: gives 4 degrees under its torque
    brake_damping_n_m_sprad  = 4,    -- A: 0.3 of critical
  },
}

return lsos.rover {
  api  = 1,
  name = 'Husky',
  doc  = 'Skid-steer field rover of 50 kg in the class of a Husky A200: four rubber tyres.',
  crew = 0,

  chassis = lsos.chassis {
    mass_kg          = body_kg,
    size_m           = vec(0.99, 0.44, 0.26),  -- R: 0.99 x 0.67 x 0.39 m; D: between wheels
    clearance_m      = 0.13,                         -- R: data sheet
    center_of_mass_m = vec(0, 0, 0.194),       -- V: model, 0.062 m above its bottom plate
    inertia_kgm2     = body_kg / 46.03 * vec(0.602, 1.739, 2.030),  -- V: model; D: scaled
  },
  suspension = suspension,

  configurations = {
    lsos.configuration {
      name               = 'FullPayload',
      doc                = 'With 75 kg on its top plate.',
      payload_mass_kg    = 75,                     -- R: data sheet
      payload_position_m = vec(0, 0, 0.5),   -- A
    },
  },

  step_s               = 0.005,  -- D: omega x step is 0.81 along the ground, its stiffest mode
  cruise_speed_mps     = 0.7,    -- A
  speed_max_mps        = 1.0,    -- V: max_velocity, control
  acceleration_mps2    = 0.5,    -- A: far below the 3 m/s2 of control
  can_turn_on_spot     = true,   -- D: skid steering
  turning_radius_min_m = 0.5,    -- A

  battery = lsos.battery {
    capacity_j           = 24 * 20 * 3600,  -- R: 24 V, 20 A h
    discharge_efficiency = 0.9,             -- A: lead and acid
  },
  loads = { lsos.load { name = 'computer', power_w = 30 } },  -- A
  shapes = {
    box(vec(0.9, 0.42, 0.2), vec(0, 0, 0.24), '#e0b820'),
    box(vec(0.7, 0.4, 0.06), vec(0, 0, 0.37), '#303030'),
  },

  assumptions = {
    'Husky: a battery of 480 W h with an efficiency of 0.9 and 30 W for its computer are assumed',
    'Husky: 50 kg with four wheels of 2.6 kg; tyres of 40 kN/m that lose 2 % of their load in '
      .. 'flexing and shear soil on soil are assumed',
    'Husky: it turns as if its track were 1.875 times as wide, the value of its maker\'s '
      .. 'controller; soils differ',
    'Husky: drives of 50 N m and 100 W a wheel and 9 rad/s without load are assumed, whose gears '
      .. 'have an efficiency of 0.7, and which lose 0.02 W/(N m)2 in their windings, 1 N m by '
      .. 'friction and 3 W in their controllers',
    'Husky: drive servos, brakes and their springs, a cruise speed of 0.7 m/s and an acceleration '
      .. 'of 0.5 m/s2 are assumed',
  },
}
