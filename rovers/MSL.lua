-- NASA's Mars Science Laboratory (Curiosity): six wheels on rockers and bogies as MER has them, at
-- twice the size, the four at the corners steered, with a radioisotope generator.
--
-- Each number says where it is from: (V) read in the source, (S) second-hand, (R) recalled, source
-- not seen, (D) computed from those, (A) our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local gear = require 'lib/running_gear'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local total_kg        = 899    -- R
local rocker_kg       = 25     -- A: of a side
local bogie_kg        = 12     -- A: of a side
local knuckle_kg      = 12     -- A: of a corner, with the steering motor
local wheel_kg        = 20     -- A: with the drive motor
local differential_kg = 15     -- A
local half_base_m     = 1.1    -- R: wheelbase 2.2 m
local pivot_m         = 0.85   -- A: height of the rockers' pivots

-- D: moment of a wheel about its axle, a solid disc; A: three times that, as for MER
local axle_kgm2 = 1.9

local chassis = lsos.chassis {
  mass_kg = total_kg - differential_kg - 2 * (rocker_kg + bogie_kg)  -- D: 642
    - 4 * knuckle_kg - 6 * wheel_kg,
  size_m           = vec(1.7, 1.2, 0.45),  -- A: body without mast and arm
  clearance_m      = 0.66,                 -- R
  center_of_mass_m = vec(0, 0, 0.9),       -- A: over the rockers' pivots
}

local suspension = lsos.rocker_bogie {
  -- D: width of 2.7 to 2.8 m (R) less a wheel's; A: the middle wheels stand out as MER's do
  stations        = gear.stations(half_base_m, 1.15, 1.2),
  knuckle_mass_kg = knuckle_kg,

  -- A: pivots where wheels carry the same, as for MER
  rocker = lsos.rocker {
    pivot_m                 = vec(0, 0.7, pivot_m),  -- A
    mass_kg                 = rocker_kg,
    angle_max_rad           = 0.5,   -- A
    stop_stiffness_n_m_prad = 4e4,   -- A
    stop_damping_n_m_sprad  = 2000,  -- A
    damping_n_m_sprad       = 100,   -- A
  },
  bogie = lsos.bogie {
    pivot_m                 = vec(-half_base_m / 2, 0.95, 0.5),  -- A
    mass_kg                 = bogie_kg,
    angle_max_rad           = 0.7,   -- A
    stop_stiffness_n_m_prad = 2e4,   -- A
    stop_damping_n_m_sprad  = 800,   -- A
    damping_n_m_sprad       = 40,    -- A
  },
  differential = lsos.differential {
    kind               = 'bar',    -- R: across the deck
    position_m         = vec(0, 0, 1.15),  -- A
    mass_kg            = differential_kg,
    stiffness_n_m_prad = 1e5,      -- A
    damping_n_m_sprad  = 1500,     -- A
  },

  steering = lsos.steering {
    angle_max_rad      = math.rad(60),  -- A: turning on the spot takes 44 degrees (D)
    rate_max_radps     = 0.1,           -- A
    torque_max_n_m     = 300,           -- A: turns a standing wheel in soil
    stiffness_n_m_prad = 2500,          -- A
    damping_n_m_sprad  = 40,            -- A: half of critical
  },

  wheel = lsos.wheel {
    radius_m                 = 0.25,   -- V: 0.50 m diameter, abstract of Arvidson et al. 2017
    width_m                  = 0.40,   -- S: planetary.org, 'Diagram of a Curiosity wheel'
    mass_kg                  = wheel_kg,
    inertia_kgm2             = vec(0.58, axle_kgm2, 0.58),  -- D: across the axle a disc
    normal_stiffness_npm     = 1e5,    -- A: 6 mm under its load on Mars
    normal_damping_nspm      = gear.damping(0.5, 1e5, wheel_kg),  -- A
    tangential_damping_nspm  = 500,    -- A
    grouser_height_m         = 0.0075, -- S: the same
    grouser_count            = 24,     -- S: the same, one in 15 degrees; R: 19 by other counts
    interface_friction_ratio = 0.8,    -- A: as for MER
  },

  drive = lsos.drive {
    torque_max_n_m           = 210,    -- A: at the rims 1.5 of the rover's weight on Mars (D)
    power_max_w              = 25,     -- A
    no_load_speed_radps      = 0.22,   -- A: a third above the greatest speed
    efficiency               = 0.6,    -- A: gears of four stages
    winding_loss_w_pn2m2     = 0.003,  -- A: 11 W at 60 N m, a steep climb
    friction_n_m             = 3,      -- A: gears in their lubricant
    idle_w                   = 1,      -- A: of the controller
    servo_gain_n_m_sprad     = 100,    -- A: two thirds of what the step allows (D)
    servo_integral_n_m_prad  = 600,    -- A: a lasting load is made up in 0.17 s
    brake_torque_max_n_m     = 300,    -- A: gears hold the wheel
    brake_stiffness_n_m_prad = 6000,   -- A: gives 3 degrees under its torque
    brake_damping_n_m_sprad  = gear.damping(0.4, 6000, axle_kgm2),  -- A
  },
}

local white, grey, dark, black = '#e8e8e4', '#9a9a98', '#404448', '#282828'

return lsos.rover {
  api  = 1,
  name = 'MSL',
  doc  = 'Mars Science Laboratory (Curiosity): six wheels on rockers and bogies, four steered.',
  crew = 0,

  chassis    = chassis,
  suspension = suspension,

  step_s               = 0.0125,  -- D: omega x step is 0.89 for the differential, its stiffest mode
  cruise_speed_mps     = 0.03,    -- A: three quarters of the greatest
  speed_max_mps        = 0.04,    -- S: 4 cm/s, space.com infographic of 2012
  acceleration_mps2    = 0.02,    -- A
  can_turn_on_spot     = true,    -- S: turns in place, mars.nasa.gov 'New wheels'
  turning_radius_min_m = 2.0,     -- A: within the steering's 60 degrees
  limits = lsos.limits {
    slope_max_rad = math.rad(23),  -- V: mixed slope climbed on Mount Sharp, press of 2023
  },

  battery = lsos.battery {
    capacity_j           = 2 * 42 * 28 * 3600,  -- R: two batteries of 42 A h; A: at 28 V
    charge_efficiency    = 0.95,                -- A
    discharge_efficiency = 0.95,                -- A
    reserve              = 0.4,                 -- A
  },
  generator_w = 110,  -- S: USA Today, August 2012
  loads = {
    lsos.load { name = 'avionics', power_w = 50 },                    -- A: asleep as well
    lsos.load { name = 'awake', power_w = 150, when = 'driving' },    -- A: computers, cameras
  },
  shapes = {
    box(vec(1.7, 1.2, 0.45), vec(0, 0, 0.885), white),
    box(vec(1.6, 1.1, 0.03), vec(0, 0, 1.125), dark),
    tube(0.03, 1.4, vec(0, 1, 0), vec(0, 0, 1.17), grey),                     -- differential bar
    tube(0.16, 0.55, vec(-1, 0, 0.5), vec(-1.15, 0, 1.1), black),             -- generator
    box(vec(0.6, 0.03, 0.5), vec(-1.1, 0.35, 1.08), white),                   -- its radiators
    box(vec(0.6, 0.03, 0.5), vec(-1.1, -0.35, 1.08), white),
    tube(0.05, 0.75, nil, vec(0.7, -0.45, 1.5), white),                       -- mast
    box(vec(0.3, 0.4, 0.25), vec(0.75, -0.45, 2.0), white),
    tube(0.13, 0.03, vec(1, 0, 0), vec(0.91, -0.45, 2.02), black),
    tube(0.15, 0.04, vec(-0.2, 0, 1), vec(-0.3, 0.4, 1.35), grey),            -- antennas
    tube(0.06, 0.3, nil, vec(-0.65, -0.4, 1.28), grey),
    tube(0.06, 1.0, vec(0, 1, 0), vec(1.0, 0.05, 1.0), white),                -- stowed arm
    tube(0.05, 0.8, vec(0, 1, 0.1), vec(1.15, 0.1, 0.85), white),
    tube(0.22, 0.3, vec(1, 0, 0), vec(1.2, 0.5, 0.95), grey),
  },

  assumptions = {
    'MSL: loads of 50 W at all times and 150 W more while it drives are assumed',
    'MSL: batteries of 42 A h at 28 V with 0.95 either way and a reserve of 40 % are assumed',
    'MSL: 899 kg with a suspension of 257 kg, wheels included, a wheelbase of 2.2 m, tracks of '
      .. '2.3 and 2.4 m and a centre of mass at 0.9 m over the pivots are assumed',
    'MSL: pivots, stops, bearings and a differential of 100 kN m/rad are assumed',
    'MSL: 100 kN/m along the normal and an interface friction of 0.8, as for MER, are assumed for '
      .. 'the wheels; the chevrons of their grousers are not modelled',
    'MSL: drives of 210 N m a wheel and 0.22 rad/s without load are assumed, whose gears have an '
      .. 'efficiency of 0.6, and which lose 0.003 W/(N m)2 in their windings, 3 N m by friction '
      .. 'and 1 W in their controllers, as are the steering servos',
    'MSL: drive servos, brakes and their springs, a cruise speed of 0.03 m/s and an acceleration '
      .. 'of 0.02 m/s2 are assumed',
  },
}
