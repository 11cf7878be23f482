-- NASA's Lunar Roving Vehicle of Apollo 15 to 17 with two crew and their load: four wire-mesh
-- wheels on double arms with torsion bars, steered in front and at the rear.
--
-- Each number says where it is from: (V) read in the source, (R) recalled, source not seen,
-- (D) computed from those, (A) our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local gear = require 'lib/running_gear'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local gross_kg    = 697     -- V: Apollo 15, encyclopedia articles on the LRV
local empty_kg    = 210     -- V: the same
local astronaut_kg = 181.5  -- R: 363 kg for two in their suits
local wheelbase_m = 2.3     -- V: the same articles; 7.5 feet in 'Apollo Moonships' p. 81
local track_m     = 1.83    -- V: 6 feet between wheel centres, 'Apollo Moonships' p. 81
local arm_kg      = 4       -- A: both arms of a wheel
local knuckle_kg  = 9       -- A: with the traction drive
local wheel_kg    = 5.5     -- R: 12 lb

local modules = gear.modules({ 'front', 'rear' }, wheelbase_m, track_m)

local clearance_m = 0.356   -- V: 14 in loaded (17 in empty), web.mit.edu/12.000 (2004)
local load_m      = vec(0, 0, 0.85)  -- A: of crew and load together

local chassis = lsos.chassis {
  mass_kg          = gross_kg - #modules * (arm_kg + knuckle_kg + wheel_kg),  -- D: 623
  size_m           = vec(2.6, 1.4, 0.78),  -- A: between the wheels; D: height 1.14 m (V)
  clearance_m      = clearance_m,
  center_of_mass_m = vec(0, 0, 0.75),      -- A: batteries low, crew high
}

local suspension = lsos.wishbone {
  modules         = modules,
  arm_mass_kg     = arm_kg,
  knuckle_mass_kg = knuckle_kg,

  spring = lsos.spring {
    stiffness_npm = 2600,   -- D: 3 in (V) under 487 kg on the Moon, four wheels
    damping_nspm  = 640,    -- A: half of critical with 156 kg a wheel (D)
    travel_up_m   = 0.15,   -- A
    travel_down_m = 0.15,   -- A
  },

  steering = lsos.steering {
    angle_max_rad      = math.rad(50),  -- R: inner wheels 50 degrees, outer 22
    rate_max_radps     = 0.32,          -- R: from stop to stop in 5.5 s
    torque_max_n_m     = 120,           -- A: turns a standing wheel in soil
    stiffness_n_m_prad = 5000,          -- A
    damping_n_m_sprad  = 60,            -- A
  },

  wheel_offsets_m = { 0 },   -- A: wheels on their steering axes
  wheel = lsos.wheel {
    radius_m                 = 0.41,    -- V: 82 cm diameter, sservi.nasa.gov
    width_m                  = 0.23,    -- V: 23 cm, the same
    mass_kg                  = wheel_kg,
    normal_stiffness_npm     = 5e4,     -- A: along the contact's normal, for the step
    normal_damping_nspm      = 500,     -- A
    tangential_damping_nspm  = 200,     -- A
    interface_friction_ratio = 0.8,     -- A: chevrons on half of the mesh shear soil on soil
    carcass_stiffness_npm    = 5500,    -- A: mesh flattened by 5 cm under its lunar load
    rolling_resistance       = 0.08,    -- D: 39 Wh/km on the level; A: the mesh's own flexing
  },

  drive = lsos.drive {
    -- A: at the rims more than its whole lunar weight, so that grip ends a climb and torque does
    -- not
    torque_max_n_m           = 120,
    power_max_w              = 186,   -- V: 0.25 hp, encyclopedia articles; at the wheel: A
    no_load_speed_radps      = 13.1,  -- R: motor to 10,000 rpm; V: 80:1
    efficiency               = 0.8,   -- A: harmonic drive
    winding_loss_w_pn2m2     = 0.04,  -- A: 4 W at 10 N m, the torque on the level
    friction_n_m             = 2,     -- A: seals and harmonic drive
    idle_w                   = 5,     -- A: of the controller
    servo_gain_n_m_sprad     = 60,    -- A: full torque at 2 rad/s too slow
    servo_integral_n_m_prad  = 60,    -- A: a lasting load is made up in a second
    brake_torque_max_n_m     = 200,   -- A: holds any wheel that has grip
    brake_stiffness_n_m_prad = 5000,  -- A: gives 2 degrees under its torque
    brake_damping_n_m_sprad  = 30,    -- A: 0.3 of critical
  },
}

return lsos.rover {
  api  = 1,
  name = 'LRV',
  doc  = 'Lunar Roving Vehicle of Apollo 15: four wheels, front and rear steering, two crew.',
  crew = 2,  -- R: as Apollo 15 to 17 drove it

  chassis    = chassis,
  suspension = suspension,

  configurations = {
    lsos.configuration {
      name               = 'OneCrew',
      doc                = 'Without the right-hand astronaut.',
      crew               = 1,
      payload_mass_kg    = -astronaut_kg,
      payload_position_m = vec(0, -0.35, 0.85),  -- A: of the right seat
    },
    lsos.configuration {
      name               = 'Empty',
      doc                = 'Without crew and load.',
      crew               = 0,
      payload_mass_kg    = empty_kg - gross_kg,
      payload_position_m = load_m,
    },
  },

  step_s               = 0.005,  -- D: omega x step is 0.68 along the ground, its stiffest mode
  cruise_speed_mps     = 2.5,    -- A: 9 km/h
  speed_max_mps        = 3.6,    -- V: 13 km/h by design, encyclopedia articles
  acceleration_mps2    = 0.5,    -- A
  turning_radius_min_m = 3.1,    -- V: 10 feet, 'Apollo Moonships' p. 81
  limits = lsos.limits {
    slope_max_rad = math.rad(25),  -- V: the most it was designed for, Apollo 16 Mission Report 8.1
  },

  battery = lsos.battery {
    capacity_j           = 242 * 36 * 3600,  -- V: 242 A h (Apollo 16 Mission Report); R: 36 V
    discharge_efficiency = 0.95,             -- A
  },
  loads = {
    lsos.load { name = 'communications', power_w = 60 },  -- A: LCRU and camera
    lsos.load { name = 'navigation', power_w = 20 },      -- A
  },
  shapes = {
    box(vec(3.0, 1.0, 0.06), vec(0, 0, 0.5), '#b0a070'),
    box(vec(0.45, 0.45, 0.08), vec(-0.1, 0.35, 0.75), '#d8d0b0'),
    box(vec(0.45, 0.45, 0.08), vec(-0.1, -0.35, 0.75), '#d8d0b0'),
    box(vec(0.08, 0.45, 0.55), vec(-0.35, 0.35, 1.0), '#d8d0b0'),
    box(vec(0.08, 0.45, 0.55), vec(-0.35, -0.35, 1.0), '#d8d0b0'),
    box(vec(0.5, 0.8, 0.35), vec(1.2, 0, 0.75), '#e8e8e0'),
    box(vec(0.5, 1.0, 0.6), vec(-1.2, 0, 0.9), '#c8c8c0'),
    tube(0.02, 1.2, nil, vec(1.35, 0.35, 1.4), '#a0a0a0'),
    tube(0.48, 0.05, vec(0.3, 0, 1), vec(1.35, 0.35, 2.05), '#c0a860'),
  },

  assumptions = {
    'LRV: a battery efficiency of 0.95 and 80 W for communications and navigation are assumed',
    'LRV: 74 kg of wheels, arms and traction drives, the load at 0.85 m and the centre of mass at '
      .. '0.75 m are assumed',
    'LRV: a mesh of 5.5 kN/m, which loses 8 % of its load in flexing, and an interface friction '
      .. 'of 0.8 are assumed',
    'LRV: springs of 2.6 kN/m follow from the clearance loaded and empty; dampers at half of '
      .. 'critical, 0.15 m of travel either way and steering servos are assumed',
    'LRV: drives of 120 N m a wheel are assumed, whose gears have an efficiency of 0.8, and which '
      .. 'lose 0.04 W/(N m)2 in their windings, 2 N m by friction and 5 W in their controllers',
    'LRV: drive servos, brakes and their springs, a cruise speed of 2.5 m/s and an acceleration of '
      .. '0.5 m/s2 are assumed',
  },
}
