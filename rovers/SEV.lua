-- NASA's Space Exploration Vehicle: a pressurised rover for two, twelve wheels in six steerable
-- modules of two.
--
-- Each number says where it is from: (V) read in the source, (R) recalled, source not seen,
-- (D) computed from those, (A) our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local gear = require 'lib/running_gear'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local payload_kg   = 1000                -- R: NASA SEV fact sheet
local total_kg     = 3000 + payload_kg   -- V: 3000 kg, NASA lunar science LER page
local wheelbase_m  = 4.0                 -- V: encyclopedia articles on the SEV
local track_m      = 3.0                 -- A: between the steering axes
local arm_kg       = 40                  -- A
local knuckle_kg   = 40                  -- A: with the steering motor and two drive motors
local wheel_kg     = 30                  -- A

local modules = gear.modules({ 'front', 'middle', 'rear' }, wheelbase_m, track_m)

local chassis = lsos.chassis {
  mass_kg          = total_kg - #modules * (arm_kg + knuckle_kg + 2 * wheel_kg),  -- D: 3160
  size_m           = vec(4.5, 2.0, 2.4),  -- V: length 4.5; A: width between the wheels
  clearance_m      = 0.6,                       -- D: height 3 m (V) less the box
  center_of_mass_m = vec(0, 0, 1.3),      -- A: batteries below the floor
}

local suspension = lsos.wishbone {
  modules         = modules,
  arm_mass_kg     = arm_kg,
  knuckle_mass_kg = knuckle_kg,

  spring = lsos.spring {
    stiffness_npm = 1e4,    -- A: 0.7 Hz ride with 527 kg a module (D)
    damping_nspm  = 3200,   -- A: 0.7 of critical
    travel_up_m   = 0.25,   -- A
    travel_down_m = 0.25,   -- A
  },

  steering = lsos.steering {
    angle_max_rad      = math.pi,    -- V: 360 degrees, lunarsettlementindex.org quoting NASA
    rate_max_radps     = 0.5,        -- A
    torque_max_n_m     = 2000,       -- A: turns two wheels standing in soil
    stiffness_n_m_prad = 2e4,        -- A
    damping_n_m_sprad  = 600,        -- D: 0.7 of critical
  },

  wheel_offsets_m = { 0.2, -0.2 },   -- A: twin wheels 0.1 m apart
  wheel = lsos.wheel {
    radius_m                 = 0.495,    -- R: 99 cm diameter, NASA SEV fact sheet
    width_m                  = 0.305,    -- R: 30.5 cm, the same
    mass_kg                  = wheel_kg,
    normal_stiffness_npm     = 1e5,      -- A: 5 mm under a wheel's lunar load
    normal_damping_nspm      = 2500,     -- A
    tangential_damping_nspm  = 500,      -- A
    interface_friction_ratio = 1,        -- A: tyre treads shear soil on soil
  },

  drive = lsos.drive {
    torque_max_n_m           = 730,    -- D: 4000 lbf in low gear (V: Chariot, 2007) on 12 wheels
    power_max_w              = 1500,   -- A
    efficiency               = 0.9,    -- A: gears
    winding_loss_w_pn2m2     = 0.002,  -- A: 2 W at 35 N m, the torque on the level
    friction_n_m             = 2,      -- A: seals and gears
    idle_w                   = 5,      -- A: of the controller
    servo_gain_n_m_sprad     = 300,    -- A: full torque at 2.4 rad/s too slow
    servo_integral_n_m_prad  = 300,    -- A: a lasting load is made up in a second
    brake_torque_max_n_m     = 1500,   -- A: holds twice what the motor gives
    brake_stiffness_n_m_prad = 2e4,    -- A: gives 4 degrees under its torque
    brake_damping_n_m_sprad  = 200,    -- A: 0.4 of critical
  },
}

local battery = lsos.battery {
  capacity_j           = 40 * 3.6e6,  -- A: 40 kWh, 320 kg at 125 Wh/kg (V: autoblog 2009-09)
  charge_efficiency    = 0.96,        -- A
  discharge_efficiency = 0.96,        -- A
  reserve              = 0.1,         -- A
}

local panel = lsos.panel {
  name          = 'Roof',
  position_m    = vec(-0.6, 0, 4.2),  -- A: on a mast over the cabin
  length_m      = 2.0,                      -- A
  width_m       = 4.0,                      -- A
  efficiency    = 0.29,                     -- A: triple-junction cells
  factor        = 0.9,                      -- A: packing, wiring and conversion
  azimuth_min_rad   = -math.pi,             -- A: turns all round and tips to the horizon
  azimuth_max_rad   = math.pi,
  elevation_min_rad = 0,
  elevation_max_rad = math.pi / 2,
  rate_radps    = math.rad(1),              -- A
  motor_w       = 50,                       -- A
  stowable      = true,
  deploy_s      = 300,                      -- A
  deploy_w      = 100,                      -- A
}

local white, grey, dark, gold = '#e8e8e4', '#9a9a98', '#30343a', '#c8a040'
local shapes = {
  box(vec(4.6, 1.6, 0.25), vec(0, 0, 0.75), grey),
  box(vec(2.6, 1.9, 1.9), vec(0.2, 0, 1.95), white),
  box(vec(0.9, 1.7, 1.5), vec(1.85, 0, 1.85), white),
  box(vec(0.1, 1.5, 0.6), vec(2.32, 0, 2.15), dark),
  box(vec(0.8, 0.06, 0.6), vec(1.8, 0.87, 2.15), dark),
  box(vec(0.8, 0.06, 0.6), vec(1.8, -0.87, 2.15), dark),
  box(vec(0.8, 1.7, 0.2), vec(-1.5, 0, 1.0), grey),
  box(vec(0.35, 0.6, 1.5), vec(-1.3, 0.45, 1.9), gold),
  box(vec(0.35, 0.6, 1.5), vec(-1.3, -0.45, 1.9), gold),
  tube(0.05, 1.2, nil, vec(-0.6, 0, 3.5), grey),
  tube(0.02, 0.8, nil, vec(0.9, 0.7, 3.3), grey),
  tube(0.06, 2.3, nil, vec(-2.0, 0, 2.05), grey),  -- the mast's foot
}

return lsos.rover {
  api  = 1,
  name = 'SEV',
  doc  = 'Pressurised rover for two, twelve wheels in six steerable modules.',
  crew = 2,  -- R: NASA SEV fact sheet

  chassis    = chassis,
  suspension = suspension,

  configurations = {
    lsos.configuration {
      name               = 'Unloaded',
      doc                = 'Without its payload.',
      payload_mass_kg    = -payload_kg,
      payload_position_m = vec(0, 0, 1.3),  -- A: at the centre of mass
    },
  },

  step_s            = 0.010,  -- D: omega x step is 0.85 along the ground, its stiffest mode
  cruise_speed_mps  = 2.0,    -- A: 7 km/h
  speed_max_mps     = 2.78,   -- V: 10 km/h in any direction, lunarsettlementindex.org quoting NASA
  acceleration_mps2 = 0.3,    -- A
  can_turn_on_spot  = true,   -- D: all modules steer
  can_crab          = true,   -- V: in any direction, the same

  battery = battery,
  panels  = { panel },
  loads   = {
    lsos.load { name = 'cabin', power_w = 500 },                  -- A: air, avionics, cooling
    lsos.load { name = 'radio', power_w = 50 },                   -- A
    lsos.load { name = 'heaters', power_w = 300, when = 'dark' }, -- A
  },
  resources = {
    -- A: as much as two breathe in 14 days at 0.84 kg a day each. EVAs take theirs from it; what
    -- the crew breathes aboard is not counted.
    lsos.resource { name = 'oxygen', unit = 'kg', amount = 24 },  -- A
    lsos.resource { name = 'sample bags', unit = 'bags', amount = 100 },  -- A
  },
  shapes = shapes,
  antennas = {
    lsos.antenna {
      name              = 'Mast',
      position_m        = vec(-2.0, 0, 8.0),   -- A: on a telescopic mast at the rear
      stowed_position_m = vec(-2.0, 0, 3.2),   -- A
      deploy_s          = 600,                 -- A
      deploy_w          = 150,                 -- A
      power_w           = 60,                  -- A
      range_max_m       = 30e3,                -- A
    },
    lsos.antenna {
      name          = 'Whip',
      position_m    = vec(0.9, 0.7, 3.8),      -- A: over the cabin
      range_max_m   = 5e3,                     -- A
      reaches_earth = false,                   -- A
    },
  },

  assumptions = {
    'SEV: a battery of 40 kWh with 0.96 either way, a reserve of 10 %, a panel of 8 m2 on a mast '
      .. 'with 0.29 x 0.9, loads of 550 W and 300 W of heaters in the dark are assumed',
    'SEV: an antenna over the cabin that reaches 5 km, and one on a mast of 8 m that reaches 30 km '
      .. 'and Earth, are assumed',
    'SEV: 4000 kg in all, read as 3000 kg of vehicle and 1000 kg of payload; sources disagree',
    'SEV: wheel modules of 140 kg (arm 40, knuckle 40, two wheels of 30), track 3 m and centre of '
      .. 'mass at 1.3 m are assumed',
    'SEV: springs of 10 kN/m with 0.25 m of travel either way and 0.7 of critical damping are '
      .. 'assumed',
    'SEV: motors of 1.5 kW a wheel are assumed, whose gears have an efficiency of 0.9, and which '
      .. 'lose 0.002 W/(N m)2 in their windings, 2 N m by friction and 5 W in their controllers; '
      .. 'their torque is that of the Chariot chassis in low gear',
    'SEV: drive and steering servos, brakes and their springs, a cruise speed of 2 m/s and an '
      .. 'acceleration of 0.3 m/s2 are assumed',
    'SEV: treads that shear soil on soil (interface friction 1) are assumed',
  },
}
