-- NASA's Mars Exploration Rover (Spirit, Opportunity): six wheels on rockers and bogies, the four
-- at the corners steered.
--
-- Each number says where it is from: (V) read in the source, (R) recalled, source not seen,
-- (D) computed from those, (A) our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local gear = require 'lib/running_gear'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local total_kg        = 180    -- V: encyclopedia articles on Spirit; 174 to 185 elsewhere
local rocker_kg       = 5      -- A: of a side
local bogie_kg        = 3      -- A: of a side
local knuckle_kg      = 2.5    -- A: of a corner, with the steering motor
local wheel_kg        = 1.5    -- A: with the drive motor
local differential_kg = 3      -- A
local half_base_m     = 0.705  -- R: wheelbase 1.41 m
local pivot_m         = 0.45   -- A: height of the rockers' pivots

local chassis = lsos.chassis {
  mass_kg = total_kg - differential_kg - 2 * (rocker_kg + bogie_kg)  -- D: 142
    - 4 * knuckle_kg - 6 * wheel_kg,
  size_m           = vec(0.8, 0.6, 0.4),  -- A: body without panels and mast
  clearance_m      = 0.30,                      -- R
  center_of_mass_m = vec(0, 0, 0.5),      -- A: over the rockers' pivots
}

local suspension = lsos.rocker_bogie {
  -- R: track of 1.06 m at the corners, 1.22 m in the middle
  stations        = gear.stations(half_base_m, 0.53, 0.61),
  knuckle_mass_kg = knuckle_kg,

  -- Wheels carry the same when the centre of mass is over the middle wheel and the bogie's pivot
  -- halfway between its wheels.
  rocker = lsos.rocker {
    pivot_m                 = vec(0, 0.40, pivot_m),  -- A
    mass_kg                 = rocker_kg,
    angle_max_rad           = 0.6,   -- A
    stop_stiffness_n_m_prad = 4000,  -- A
    stop_damping_n_m_sprad  = 100,   -- A
    damping_n_m_sprad       = 5,     -- A
  },
  bogie = lsos.bogie {
    pivot_m                 = vec(-half_base_m / 2, 0.50, 0.25),  -- A
    mass_kg                 = bogie_kg,
    angle_max_rad           = 0.7,   -- A
    stop_stiffness_n_m_prad = 2000,  -- A
    stop_damping_n_m_sprad  = 40,    -- A
    damping_n_m_sprad       = 2,     -- A
  },
  differential = lsos.differential {
    kind               = 'gear',                   -- R: inside the body
    position_m         = vec(0, 0, pivot_m),
    mass_kg            = differential_kg,
    stiffness_n_m_prad = 10000,  -- A
    damping_n_m_sprad  = 150,    -- A
  },

  steering = lsos.steering {
    angle_max_rad      = math.rad(60),  -- A: turning on the spot takes 53 degrees (D)
    rate_max_radps     = 0.1,           -- A
    torque_max_n_m     = 35,            -- A
    stiffness_n_m_prad = 300,           -- A
    damping_n_m_sprad  = 2,             -- A
  },

  wheel = lsos.wheel {
    radius_m                 = 0.125,  -- V: 0.25 m diameter, jpl.nasa.gov spotlight 2004-03-09
    width_m                  = 0.16,   -- R
    mass_kg                  = wheel_kg,
    -- D: solid disc; A: about the axle three times that, for what the drive turns behind its gear
    inertia_kgm2             = vec(0.0091, 0.035, 0.0091),
    normal_stiffness_npm     = 3e4,    -- A: 4 mm under its load on Mars
    normal_damping_nspm      = 300,    -- A
    tangential_damping_nspm  = 100,    -- A
    grouser_height_m         = 0.006,  -- A: V only that it has cleats, encyclopedia articles
    grouser_count            = 24,     -- A
    interface_friction_ratio = 0.8,    -- A, by the slip on a tilt bed at 10 deg
  },

  drive = lsos.drive {
    torque_max_n_m           = 30,    -- A: at the rims twice the rover's weight on Mars (D)
    power_max_w              = 8,     -- A
    no_load_speed_radps      = 0.55,  -- A: a third above the greatest speed
    efficiency               = 0.6,   -- A: three gears
    winding_loss_w_pn2m2     = 0.02,  -- A: 0.5 W at 5 N m, a climb of 10 degrees
    friction_n_m             = 0.3,   -- A: gears in their lubricant
    idle_w                   = 0.2,   -- A: of the controller
    servo_gain_n_m_sprad     = 4,     -- A: three quarters of what the step allows (D)
    servo_integral_n_m_prad  = 30,    -- A: a lasting load is made up in 0.13 s
    brake_torque_max_n_m     = 40,    -- A: gears hold the wheel
    brake_stiffness_n_m_prad = 800,   -- A: gives 3 degrees under its torque
    brake_damping_n_m_sprad  = 4,     -- A: 0.4 of critical
  },
}

-- R: 1.3 m2 of triple-junction cells; A: laid out as a deck and two wings
local function panel(name, position_m, length_m)
  return lsos.panel {
    name       = name,
    position_m = position_m,
    length_m   = length_m,
    width_m    = 0.6,   -- A
    efficiency = 0.27,  -- R
    -- D: packing, wiring, conversion, and cells made for light less red. It gives the "nearly
    -- 900 W h" of the first sols (V: NASA, January 2004) through air of optical depth 0.9 (R).
    factor     = 0.70,
  }
end

return lsos.rover {
  api  = 1,
  name = 'MER',
  doc  = 'Mars Exploration Rover: six wheels on rockers and bogies, four steered.',
  crew = 0,

  chassis    = chassis,
  suspension = suspension,

  configurations = {
    lsos.configuration {
      name          = 'RightFrontLocked',
      -- R; in loose sand it is stuck: a dragged wheel pulls back with twice its load (CMU)
      doc           = 'Spirit from March 2006 on: the right front wheel does not turn.',
      locked_wheels = { 'front_right_wheel' },
    },
    lsos.configuration {
      name          = 'RightFrontAndRearLocked',
      -- R
      doc           = 'Spirit stuck at Troy, late 2009: the right rear wheel is lost as well.',
      locked_wheels = { 'front_right_wheel', 'rear_right_wheel' },
    },
  },

  step_s               = 0.00625,  -- D: omega x step is 0.96 for a middle wheel's brake
  cruise_speed_mps     = 0.0375,   -- A: three quarters of the greatest
  speed_max_mps        = 0.05,     -- V: encyclopedia articles on Spirit
  acceleration_mps2    = 0.02,     -- A
  can_turn_on_spot     = true,     -- V: encyclopedia articles on the rocker-bogie
  turning_radius_min_m = 1.2,      -- A: within the steering's 60 degrees
  limits = lsos.limits {
    slope_max_rad = math.rad(20),  -- R: it slips all but wholly on loose sand so steep, Lindemann
                                   -- & Voorhees 2005
  },

  battery = lsos.battery {
    capacity_j           = 2 * 8 * 28 * 3600,  -- R: two batteries of 8 A h at 28 V
    charge_efficiency    = 0.95,               -- A
    discharge_efficiency = 0.95,               -- A
    reserve              = 0.2,                -- A
  },
  panels = {
    panel('Deck', vec(0, 0, 0.62), 0.9),
    panel('Left', vec(-0.1, 0.6, 0.62), 0.62),
    panel('Right', vec(-0.1, -0.6, 0.62), 0.62),
  },
  loads = {
    lsos.load { name = 'avionics', power_w = 20 },                 -- A
    lsos.load { name = 'heaters', power_w = 10, when = 'dark' },   -- A
  },
  shapes = {
    box(vec(0.7, 0.5, 0.25), vec(0, 0, 0.46), '#c8a040'),
    box(vec(0.9, 0.6, 0.02), vec(0, 0, 0.605), '#202848'),
    box(vec(0.62, 0.6, 0.02), vec(-0.1, 0.6, 0.605), '#202848'),
    box(vec(0.62, 0.6, 0.02), vec(-0.1, -0.6, 0.605), '#202848'),
    tube(0.04, 0.75, nil, vec(0.42, 0.15, 1.0), '#d0d0d0'),
    box(vec(0.12, 0.3, 0.14), vec(0.42, 0.15, 1.43), '#d0d0d0'),
    tube(0.14, 0.03, vec(-0.3, 0, 1), vec(0.1, -0.22, 0.85), '#b0b0b0'),
  },

  assumptions = {
    'MER: batteries of 8 A h at 28 V with 0.95 either way, a reserve of 20 %, panels of 1.28 m2 '
      .. 'with 0.27 x 0.70, 20 W of avionics and 10 W of heaters in the dark are assumed',
    'MER: 180 kg, read as 174 to 185 kg in the sources; suspension of 38 kg with wheels, and a '
      .. 'centre of mass at 0.5 m over the pivots are assumed',
    'MER: pivots, stops, bearings and a differential of 10 kN m/rad are assumed',
    'MER: 24 grousers of 6 mm and 30 kN/m along the normal are assumed for the wheels, and an '
      .. 'interface friction of 0.8 between the grousers, with which it slips by 23 % on 10 deg of '
      .. 'loose dry sand as on a tilt bed (20 %), but stops on 15 deg, where 40 to 60 % was '
      .. 'measured',
    'MER: drives of 30 N m a wheel and 0.55 rad/s without load are assumed, whose gears have an '
      .. 'efficiency of 0.6, and which lose 0.02 W/(N m)2 in their windings, 0.3 N m by friction '
      .. 'and 0.2 W in their controllers, as are the steering servos',
    'MER: drive servos, brakes and their springs, a cruise speed of 0.0375 m/s and an acceleration '
      .. 'of 0.02 m/s2 are assumed',
  },
}
