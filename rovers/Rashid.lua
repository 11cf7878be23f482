-- The Emirates Lunar Mission's Rashid: a micro-rover of 10 kg on four wheels that do not steer.
--
-- Each number says where it is from: (V) read in the source, (S) second-hand, (R) recalled, source
-- not seen, (D) computed from those, (A) our assumption, which summary.json repeats. 'Hurrell' is
-- Hurrell et al. 2025 (Space Sci. Rev. 221:37) and 'Els' Els et al. 2021 (LPSC 1905), both as a
-- table of published rovers has them.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local gear = require 'lib/running_gear'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local total_kg        = 10     -- V: Hurrell
local rocker_kg       = 0.4    -- A: of a side
local wheel_kg        = 0.5    -- A: with the drive motor
local differential_kg = 0.2    -- A

-- V: footprint of 0.535 x 0.539 m, Els. D: less wheels with their grousers. The same table has a
-- wheelbase of 0.50 m after it, with which the wheels would reach 0.1 m beyond that.
local wheelbase_m = 0.305
local track_m     = 0.459  -- D: likewise

-- D: moment of a wheel about its axle, a solid disc; A: five times that, for what the drive turns
-- behind its gear
local axle_kgm2 = 0.0125

local suspension = lsos.skid_steer {
  stations = {
    lsos.station { name = 'front', position_m = vec(wheelbase_m / 2, track_m / 2, 0) },
    lsos.station { name = 'rear', position_m = vec(-wheelbase_m / 2, track_m / 2, 0) },
  },
  turning_track_ratio = 1.44,  -- D: 1 + (wheelbase/track)^2, with even friction

  rocker = lsos.rocker {  -- A: that its wheels hang on rockers
    pivot_m                 = vec(0, 0.17, 0.2),  -- A
    mass_kg                 = rocker_kg,
    angle_max_rad           = 0.4,  -- A
    stop_stiffness_n_m_prad = 20,   -- A
    stop_damping_n_m_sprad  = 0.5,  -- A
    damping_n_m_sprad       = 0.02, -- A
  },
  differential = lsos.differential {
    kind               = 'gear',    -- A
    position_m         = vec(0, 0, 0.2),  -- A
    mass_kg            = differential_kg,
    stiffness_n_m_prad = 30,        -- A
    damping_n_m_sprad  = 0.4,       -- A
  },

  wheel = lsos.wheel {
    radius_m                 = 0.1,    -- V: Hurrell
    width_m                  = 0.08,   -- V: Hurrell
    mass_kg                  = wheel_kg,
    inertia_kgm2             = vec(0.0015, axle_kgm2, 0.0015),  -- D: across the axle a disc
    normal_stiffness_npm     = 1000,   -- A: 4 mm under its lunar load
    normal_damping_nspm      = gear.damping(0.5, 1000, wheel_kg),  -- A
    tangential_damping_nspm  = 10,     -- A
    grouser_height_m         = 0.015,  -- V: Hurrell
    grouser_count            = 14,     -- V: Hurrell
    interface_friction_ratio = 0.65,   -- A: bare metal on sand
  },

  drive = lsos.drive {
    torque_max_n_m           = 1.0,   -- A: at the rims 2.5 of the rover's lunar weight (D)
    power_max_w              = 2,     -- A
    no_load_speed_radps      = 1.5,   -- A: half as much again as at the greatest speed
    efficiency               = 0.6,   -- A: gears
    winding_loss_w_pn2m2     = 4,     -- A: 0.2 W at 0.2 N m, a climb of 20 degrees
    friction_n_m             = 0.03,  -- A: seals and gears
    idle_w                   = 0.2,   -- A: of the controller
    servo_gain_n_m_sprad     = 0.3,   -- A: 0.4 of what the step allows (D)
    servo_integral_n_m_prad  = 1.5,   -- A: a lasting load is made up in 0.2 s
    brake_torque_max_n_m     = 1.2,   -- A: gears hold the wheel
    brake_stiffness_n_m_prad = 20,    -- A: gives 3 degrees under its torque
    brake_damping_n_m_sprad  = gear.damping(0.4, 20, axle_kgm2),  -- A
  },
}

local white, grey, dark, blue = '#e8e8e4', '#9a9a98', '#30343a', '#202848'

return lsos.rover {
  api  = 1,
  name = 'Rashid',
  doc  = 'Micro-rover of 10 kg (Emirates Lunar Mission): four wheels, skid steering.',
  crew = 0,

  chassis = lsos.chassis {
    mass_kg = total_kg - differential_kg - 2 * rocker_kg - 4 * wheel_kg,  -- D: 7
    size_m           = vec(0.40, 0.32, 0.16),  -- A
    clearance_m      = 0.15,                   -- A: over obstacles of 10 cm (S: Gulf News 2022)
    center_of_mass_m = vec(0, 0, 0.24),        -- A: over the rockers' pivots
  },
  suspension = suspension,

  step_s               = 0.0125,  -- D: omega x step is 0.69 for the differential, its stiffest mode
  cruise_speed_mps     = 0.05,   -- A: half of the greatest
  speed_max_mps        = 0.10,   -- R
  acceleration_mps2    = 0.05,   -- A
  can_turn_on_spot     = true,   -- D: skid steering
  turning_radius_min_m = 0.5,    -- A
  limits = lsos.limits {
    slope_max_rad = math.rad(20),  -- S: slopes that it descends, Gulf News 2022
  },

  battery = lsos.battery {
    capacity_j           = 50 * 3600,  -- A: as the same table estimates it
    charge_efficiency    = 0.95,       -- A
    discharge_efficiency = 0.95,       -- A
    reserve              = 0.2,        -- A
  },
  panels = {
    lsos.panel {
      name       = 'Deck',
      position_m = vec(0, 0, 0.355),  -- A
      length_m   = 0.5,               -- A: 0.25 m2, as the same table estimates it
      width_m    = 0.5,  -- A
      efficiency = 0.28,              -- A
      factor     = 0.8,               -- A: packing, wiring and conversion
    },
  },
  loads = {
    lsos.load { name = 'avionics', power_w = 8 },                 -- A
    lsos.load { name = 'heaters', power_w = 4, when = 'dark' },   -- A
  },
  shapes = {
    box(vec(0.40, 0.32, 0.18), vec(0, 0, 0.24), white),
    box(vec(0.5, 0.5, 0.015), vec(0, 0, 0.345), blue),
    tube(0.012, 0.32, nil, vec(0.18, 0, 0.49), grey),                -- mast
    box(vec(0.07, 0.12, 0.07), vec(0.18, 0, 0.665), dark),           -- S: 0.70 m high, Gulf News
  },

  assumptions = {
    'Rashid: its length and width of 0.535 and 0.539 m are read as those over its wheels; a '
      .. 'wheelbase of 0.50 m stands beside them in the same source, and does not agree with them',
    'Rashid: 10 kg with wheels of 0.5 kg, rockers tied by a differential of 30 N m/rad, and a '
      .. 'centre of mass at 0.24 m over their pivots are assumed',
    'Rashid: it turns as if its track were 1.44 times as wide; soils differ',
    'Rashid: wheels of bare metal with 1 kN/m along the normal are assumed',
    'Rashid: a battery of 50 W h with 0.95 either way and a reserve of 20 %, a panel of 0.25 m2 '
      .. 'with 0.28 x 0.8 on its deck, 8 W of avionics and 4 W of heaters in the dark are assumed',
    'Rashid: drives of 1 N m and 2 W a wheel and 1.5 rad/s without load are assumed, whose gears '
      .. 'have an efficiency of 0.6, and which lose 4 W/(N m)2 in their windings, 0.03 N m by '
      .. 'friction and 0.2 W in their controllers',
    'Rashid: drive servos, brakes and their springs, a greatest speed of 0.10 m/s, a cruise speed '
      .. 'of 0.05 m/s and an acceleration of 0.05 m/s2 are assumed',
  },
}
