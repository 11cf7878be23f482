-- NASA's Volatiles Investigating Polar Exploration Rover: four wheels, all steered, with panels on
-- three sides for a Sun that stands low. Its legs can be lifted one by one; that is not modelled,
-- springs stand in their place.
--
-- Each number says where it is from: (V) read in the source, (R) recalled, source not seen,
-- (D) computed from those, (A) our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local gear = require 'lib/running_gear'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local total_kg    = 430   -- R
local wheelbase_m = 1.0   -- D: length of 1.5 m (R) less a wheel's diameter
local track_m     = 1.3   -- D: width of 1.5 m (R) less a wheel's
local arm_kg      = 10    -- A
local knuckle_kg  = 8     -- A: with the steering and the drive motor
local wheel_kg    = 8     -- A

-- D: moment of a wheel about its axle, a solid disc; A: twice that, for what the drive turns
local axle_kgm2 = 0.5

local modules = gear.modules({ 'front', 'rear' }, wheelbase_m, track_m)

local chassis = lsos.chassis {
  mass_kg          = total_kg - #modules * (arm_kg + knuckle_kg + wheel_kg),  -- D: 326
  size_m           = vec(1.2, 1.1, 1.0),  -- A: body between the panels
  clearance_m      = 0.5,                 -- A: over wheels that are turned
  center_of_mass_m = vec(0, 0, 0.8),      -- A: batteries at the bottom
}

local suspension = lsos.wishbone {
  modules         = modules,
  arm_mass_kg     = arm_kg,
  knuckle_mass_kg = knuckle_kg,

  spring = lsos.spring {
    stiffness_npm = 6000,   -- A: 1.4 Hz ride with 82 kg a module (D)
    damping_nspm  = gear.damping(0.5, 6000, 82),  -- A
    travel_up_m   = 0.2,    -- A
    travel_down_m = 0.2,    -- A
  },

  steering = lsos.steering {
    angle_max_rad      = math.rad(95),  -- A: it drives sideways
    rate_max_radps     = 0.3,           -- A
    torque_max_n_m     = 80,            -- A: turns a standing wheel in soil
    stiffness_n_m_prad = 1200,          -- A
    damping_n_m_sprad  = 12,            -- A: a third of critical
  },

  wheel_offsets_m = { 0 },   -- A: wheels on their steering axes
  wheel = lsos.wheel {
    radius_m                 = 0.25,   -- R: 0.5 m diameter
    width_m                  = 0.2,    -- A
    mass_kg                  = wheel_kg,
    inertia_kgm2             = vec(0.15, axle_kgm2, 0.15),  -- D: across the axle a disc
    normal_stiffness_npm     = 4e4,    -- A: 4 mm under its lunar load
    normal_damping_nspm      = gear.damping(0.5, 4e4, wheel_kg),  -- A
    tangential_damping_nspm  = 200,    -- A
    grouser_height_m         = 0.015,  -- A
    grouser_count            = 24,     -- A
    interface_friction_ratio = 0.8,    -- A: as for MER
  },

  drive = lsos.drive {
    torque_max_n_m           = 60,    -- A: at the rims 1.4 of the rover's lunar weight (D)
    power_max_w              = 60,    -- A
    no_load_speed_radps      = 1.2,   -- A: half as much again as at the greatest speed
    efficiency               = 0.7,   -- A: gears
    winding_loss_w_pn2m2     = 0.02,  -- A: 5 W at 15 N m, a climb of 15 degrees
    friction_n_m             = 1,     -- A: seals and gears
    idle_w                   = 2,     -- A: of the controller
    servo_gain_n_m_sprad     = 25,    -- A: 0.6 of what the step allows (D)
    servo_integral_n_m_prad  = 150,   -- A: a lasting load is made up in 0.17 s
    brake_torque_max_n_m     = 100,   -- A: holds any wheel that has grip
    brake_stiffness_n_m_prad = 1900,  -- A: gives 3 degrees under its torque
    brake_damping_n_m_sprad  = gear.damping(0.4, 1900, axle_kgm2),  -- A
  },
}

-- A panel of a side: it stands upright and faces this way, clockwise from the nose.
local function panel(name, azimuth_deg, position_m)
  return lsos.panel {
    name          = name,
    position_m    = position_m,
    length_m      = 1.0,   -- A: its height, as it stands upright
    width_m       = 1.2,   -- A
    efficiency    = 0.30,  -- A: triple-junction cells
    factor        = 0.92,  -- D: a panel that faces the Sun gives 450 W (R)
    azimuth_rad   = math.rad(azimuth_deg),
    elevation_rad = 0,     -- A: upright
  }
end

local white, grey, gold, blue = '#e8e8e4', '#9a9a98', '#c8a040', '#202848'

return lsos.rover {
  api  = 1,
  name = 'VIPER',
  doc  = 'Polar prospector of 430 kg: four steered wheels, panels on three sides, a low Sun.',
  crew = 0,

  chassis    = chassis,
  suspension = suspension,

  step_s               = 0.0125,  -- D: omega x step is 0.91 along the ground, its stiffest mode
  cruise_speed_mps     = 0.1,     -- A: half of the greatest
  speed_max_mps        = 0.2,     -- V: 0.72 km/h, autoevolution 2022
  acceleration_mps2    = 0.1,     -- A
  can_turn_on_spot     = true,    -- D: all wheels steer
  can_crab             = true,    -- R: sideways and diagonally
  turning_radius_min_m = 1.0,     -- A
  limits = lsos.limits {
    slope_max_rad = math.rad(15),  -- R
  },

  battery = lsos.battery {
    capacity_j           = 5 * 3.6e6,  -- A: 5 kWh, which last 40 hours in the dark
    charge_efficiency    = 0.96,       -- A
    discharge_efficiency = 0.96,       -- A
    reserve              = 0.2,        -- A
  },
  panels = {
    panel('Left', -90, vec(0, 0.6, 1.0)),
    panel('Right', 90, vec(0, -0.6, 1.0)),
    panel('Rear', 180, vec(-0.65, 0, 1.0)),
  },
  loads = {
    lsos.load { name = 'avionics', power_w = 80 },                 -- A
    lsos.load { name = 'driving', power_w = 80, when = 'driving' },  -- A: cameras, radio
    lsos.load { name = 'lamps', power_w = 20, when = 'dark' },     -- A
  },
  shapes = {
    box(vec(1.2, 1.1, 1.0), vec(0, 0, 1.0), gold),
    box(vec(1.2, 0.03, 1.0), vec(0, 0.58, 1.0), blue),
    box(vec(1.2, 0.03, 1.0), vec(0, -0.58, 1.0), blue),
    box(vec(0.03, 1.2, 1.0), vec(-0.63, 0, 1.0), blue),
    box(vec(1.1, 1.0, 0.06), vec(0, 0, 1.53), white),              -- radiator
    tube(0.06, 0.7, nil, vec(0.4, 0, 1.9), grey),                  -- mast
    tube(0.2, 0.05, vec(1, 0, 0.3), vec(0.4, 0, 1.95), white),     -- antenna
    box(vec(0.2, 0.45, 0.2), vec(0.42, 0, 2.35), white),
    tube(0.06, 0.06, vec(1, 0, 0), vec(0.62, 0.4, 1.35), white),   -- lamps
    tube(0.06, 0.06, vec(1, 0, 0), vec(0.62, -0.4, 1.35), white),
  },

  assumptions = {
    'VIPER: its legs, which it can lift one by one, are not modelled: springs of 6 kN/m with 0.2 m '
      .. 'of travel either way and half of critical damping stand in their place',
    'VIPER: 430 kg with 104 kg of arms, knuckles and wheels, a wheelbase of 1 m, a track of 1.3 m '
      .. 'and a centre of mass at 0.8 m are assumed',
    'VIPER: wheels of 0.5 m by 0.2 m with 24 grousers of 15 mm, 40 kN/m along the normal and an '
      .. 'interface friction of 0.8 are assumed',
    'VIPER: a battery of 5 kWh with 0.96 either way and a reserve of 20 %, three upright panels of '
      .. '1.2 m2 with 0.30 x 0.92, 80 W of avionics, 80 W more while it drives and 20 W of lamps '
      .. 'in the dark are assumed',
    'VIPER: drives of 60 N m and 60 W a wheel and 1.2 rad/s without load are assumed, whose gears '
      .. 'have an efficiency of 0.7, and which lose 0.02 W/(N m)2 in their windings, 1 N m by '
      .. 'friction and 2 W in their controllers, as are the steering servos',
    'VIPER: drive servos, brakes and their springs, a cruise speed of 0.1 m/s and an acceleration '
      .. 'of 0.1 m/s2 are assumed',
  },
}
