-- JPL's ATHLETE of the first generation (2005): wheels on six limbs of six joints round a hexagonal
-- frame.
--
-- Each number says where it is from: (V) read in the source, (R) recalled, source not seen,
-- (D) computed from those, (A) our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local vec, rad = lsos.vec3, math.rad
local box, tube = drawn.box, drawn.tube

local total_kg   = 850    -- V: ATHLETE of 2005, Servo Magazine quoting JPL
local frame_m    = 2.75   -- V: width of the hexagonal ring, the same
local knuckle_kg = 8      -- A: with the drive motor
local wheel_kg   = 20     -- A
local radius_m   = 0.355  -- R: 0.71 m diameter, given for the second generation

-- A limb at rest, in the stance 'Drive', in its own vertical plane: distance from the frame's
-- middle and height of each joint. Thigh and shin reach a little over 2 m standing (V) and
-- 6 m across (V: goal).
local clearance_m      = 0.9                -- A: under the frame
local hip_m            = 1.25               -- A: hip yaw, below the frame's edge
local thigh_m, shin_m  = 0.95, 1.05         -- A
local yaw_at           = { r = hip_m, z = clearance_m + 0.2 }         -- A
local hip_at           = { r = hip_m + 0.15, z = clearance_m + 0.2 }  -- A
local ankle_at         = { r = 2.3, z = radius_m + 0.4 }              -- A: a fork over the wheel

-- The knee, above the line from hip to ankle.
local function knee(hip, ankle)
  local dr, dz = ankle.r - hip.r, ankle.z - hip.z
  local reach = math.sqrt(dr * dr + dz * dz)
  local along = (reach * reach + thigh_m ^ 2 - shin_m ^ 2) / (2 * reach)
  local above = math.sqrt(thigh_m ^ 2 - along ^ 2)
  return {
    r = hip.r + (along * dr - above * dz) / reach,
    z = hip.z + (along * dz + above * dr) / reach,
  }
end

local knee_at = knee(hip_at, ankle_at)
local roll_at = { r = (knee_at.r + ankle_at.r) / 2, z = (knee_at.z + ankle_at.z) / 2 }  -- A

local function limb_motor(torque_n_m, stiffness_n_m_prad, damping_n_m_sprad)
  return lsos.limb_motor {
    rate_max_radps       = 0.15,              -- A: 9 deg/s
    torque_max_n_m       = torque_n_m,        -- A: stands on three of its limbs on Earth
    stiffness_n_m_prad   = stiffness_n_m_prad,  -- A
    damping_n_m_sprad    = damping_n_m_sprad,   -- A
    brake_torque_max_n_m = 1.5 * torque_n_m,  -- A
    efficiency           = 0.5,               -- A: harmonic drive and motor
    winding_loss_w_pn2m2 = 2e-5,              -- A: 20 W at 1000 N m
    idle_w               = 2,                 -- A: of its controller
  }
end

local hip_motor   = limb_motor(3000, 4e4, 1500)
local knee_motor  = limb_motor(2000, 3e4, 800)
local ankle_motor = limb_motor(1000, 8000, 120)
local roll_motor  = limb_motor(500, 2000, 20)

local function limb(number)
  local azimuth = rad(60 * number - 30)  -- A: from ahead to the left; limbs ahead in pairs
  local out, aside = vec(math.cos(azimuth), math.sin(azimuth), 0),
                     vec(-math.sin(azimuth), math.cos(azimuth), 0)
  local function place(at) return vec(at.r * out.x, at.r * out.y, at.z) end
  local function joint(name, at, axis, motor, mass_kg, range_deg, rotor_kgm2)
    return lsos.joint {
      name = name, position_m = place(at), axis = axis, motor = motor, mass_kg = mass_kg,
      angle_min_rad = -rad(range_deg), angle_max_rad = rad(range_deg),
      inertia_kgm2  = rotor_kgm2 and vec(rotor_kgm2, rotor_kgm2, rotor_kgm2),
    }
  end
  local shin = place(ankle_at) - place(knee_at)
  return lsos.limb {
    name       = ('limb_%d'):format(number),
    position_m = vec(ankle_at.r * out.x, ankle_at.r * out.y, 0),
    joints     = {  -- A: masses, ranges, inertia with the rotors behind their gears
      joint('hip_yaw', yaw_at, vec(0, 0, 1), hip_motor, 8, 60),
      joint('hip_pitch', hip_at, aside, hip_motor, 24, 80),
      joint('knee_pitch', knee_at, aside, knee_motor, 14, 90),
      joint('knee_roll', roll_at, shin, roll_motor, 10, 170, 0.5),
      joint('ankle_pitch', ankle_at, aside, ankle_motor, 8, 90, 0.5),
    },
  }
end

local limbs = {}
for number = 1, 6 do limbs[number] = limb(number) end
local limb_kg = 8 + 24 + 14 + 10 + 8 + knuckle_kg + wheel_kg  -- D: 92

local suspension = lsos.legged {
  limbs           = limbs,
  knuckle_mass_kg = knuckle_kg,

  posture = lsos.posture {
    leveling_1ps        = 2,     -- A: a tilt is made good in half a second
    load_sharing_mps_pn = 5e-4,  -- A: 5 cm/s for 100 N too much
  },

  steering = lsos.steering {   -- the ankle's roll, the sixth joint of a limb
    angle_max_rad      = math.pi,   -- A
    rate_max_radps     = 0.5,       -- A
    torque_max_n_m     = 400,       -- A: turns a standing wheel in soil
    stiffness_n_m_prad = 3000,      -- A
    damping_n_m_sprad  = 20,        -- A
  },

  wheel = lsos.wheel {
    radius_m                 = radius_m,
    width_m                  = 0.25,   -- A
    mass_kg                  = wheel_kg,
    normal_stiffness_npm     = 3e4,    -- A: 8 mm under a wheel's lunar load
    normal_damping_nspm      = 400,    -- A
    tangential_damping_nspm  = 200,    -- A
    interface_friction_ratio = 1,      -- A: treads shear soil on soil
  },

  drive = lsos.drive {
    torque_max_n_m           = 250,    -- A: climbs 25 degrees of soft sand (V: goal) on Earth
    power_max_w              = 250,    -- A
    efficiency               = 0.8,    -- A: gears
    winding_loss_w_pn2m2     = 0.005,  -- A: 3 W at 25 N m
    friction_n_m             = 1.5,    -- A: seals and gears
    idle_w                   = 3,      -- A: of the controller
    servo_gain_n_m_sprad     = 80,     -- A
    servo_integral_n_m_prad  = 80,     -- A: a lasting load is made up in a second
    brake_torque_max_n_m     = 500,    -- A: holds twice what the motor gives
    brake_stiffness_n_m_prad = 5000,   -- A
    brake_damping_n_m_sprad  = 50,     -- A
  },
}

local deck_m = 0.4  -- A: height of the frame
local white, grey, dark = '#e8e8e4', '#9a9a98', '#30343a'
local shapes = {
  box(vec(1.0, 0.8, 0.3), vec(0, 0, clearance_m + 0.15), dark),
  tube(0.04, 1.8, nil, vec(-0.9, 0, clearance_m + deck_m + 0.9), grey),  -- mast of the panel
}
for turn = 0, 2 do  -- three boxes make a hexagon
  for _, slab in ipairs { { 1, 0.12, 0.34, white }, { 0.93, 0.2, 0.18, grey } } do
    local width_m, height_m, z_m, colour = table.unpack(slab)
    shapes[#shapes + 1] = lsos.shape {
      -- D: length and width of a hexagon's inner rectangle
      size_m     = vec(frame_m * width_m, frame_m * width_m / math.sqrt(3), height_m),
      position_m = vec(0, 0, clearance_m + z_m),
      yaw_rad    = rad(60 * turn + 30),
      colour     = colour,
    }
  end
end

return lsos.rover {
  api  = 1,
  name = 'ATHLETE',
  doc  = 'Cargo carrier on six limbs of six joints, each with a wheel (first generation, 2005).',

  chassis = lsos.chassis {
    mass_kg          = total_kg - 6 * limb_kg,                  -- D: 298
    size_m           = vec(2.4, 2.4, deck_m),                -- D: a square about the hexagon
    clearance_m      = clearance_m,
    center_of_mass_m = vec(0, 0, clearance_m + deck_m / 2),     -- A
  },
  suspension = suspension,

  configurations = {
    lsos.configuration { name = 'Drive', doc = 'As it drives: frame 0.9 m over the ground.' },
    lsos.configuration {
      name = 'Stow', doc = 'Low, for night and transport: frame 0.3 m over the ground.',
      height_m = 0.3,   -- A
    },
    lsos.configuration {
      name = 'Tall', doc = 'High over obstacles: frame 1.9 m over the ground.',
      height_m = 1.9,   -- D: deck at a little over 2 m (V)
    },
    lsos.configuration {
      name = 'Passive', doc = 'As it drives, without levelling: it lies as the ground does.',
      is_level = false,
    },
    lsos.configuration {
      name = 'Loaded', doc = 'With 300 kg of cargo on its frame.',
      payload_mass_kg    = 300,   -- V: payload on Earth, Servo Magazine quoting JPL
      payload_position_m = vec(0, 0, clearance_m + deck_m + 0.4),  -- A
    },
  },

  step_s            = 0.005,  -- D: omega x step is at most 1 in every stance
  cruise_speed_mps  = 0.4,    -- A
  speed_max_mps     = 0.56,   -- V: about 2 km/h, said of the second generation
  acceleration_mps2 = 0.1,    -- A
  can_turn_on_spot  = true,   -- D: all wheels steer
  can_crab          = true,   -- D: the same

  limits = lsos.limits {
    slope_max_rad    = rad(20),  -- A: below 25 degrees on soft sand (V: goal)
    clearance_min_m  = 0.35,     -- A: the frame stays level over a slope
    unevenness_max_m = 1.0,      -- D: its limb then stands 0.67 m above their mean, of 0.9 (A)
  },

  battery = lsos.battery {
    capacity_j           = 12 * 3.6e6,  -- A: 12 kWh
    charge_efficiency    = 0.96,        -- A
    discharge_efficiency = 0.96,        -- A
    reserve              = 0.1,         -- A
  },
  panels = {
    lsos.panel {
      name          = 'Mast',
      position_m    = vec(-0.9, 0, clearance_m + deck_m + 1.9),  -- A: on a mast
      length_m      = 1.6,                  -- A
      width_m       = 2.0,                  -- A
      efficiency    = 0.29,                 -- A: triple-junction cells
      factor        = 0.9,                  -- A: packing, wiring and conversion
      azimuth_min_rad   = -math.pi,         -- A: turns all round and tips to the horizon
      azimuth_max_rad   = math.pi,
      elevation_min_rad = 0,
      elevation_max_rad = math.pi / 2,
      rate_radps    = rad(1),               -- A
      motor_w       = 30,                   -- A
      stowable      = true,
      deploy_s      = 240,                  -- A
      deploy_w      = 60,                   -- A
    },
  },
  loads = {
    lsos.load { name = 'avionics', power_w = 150 },               -- A
    lsos.load { name = 'heaters', power_w = 100, when = 'dark' }, -- A
  },
  shapes   = shapes,
  antennas = {
    lsos.antenna {
      name              = 'Mast',
      position_m        = vec(0.9, 0, clearance_m + deck_m + 3.0),  -- A: telescopic
      stowed_position_m = vec(0.9, 0, clearance_m + deck_m + 0.4),  -- A
      deploy_s          = 300,   -- A
      deploy_w          = 60,    -- A
      power_w           = 40,    -- A
      range_max_m       = 20e3,  -- A
    },
  },

  assumptions = {
    'ATHLETE: the first generation of 2005 (850 kg, ring of 2.75 m); wheels of 0.71 m and a speed '
      .. 'of 2 km/h are those of the second',
    'ATHLETE: limbs of 92 kg with thighs of 0.95 m and shins of 1.05 m, their joints, ranges, '
      .. 'torques, rates of 9 deg/s, servos, brakes and losses are assumed',
    'ATHLETE: wheels on a ring of 2.3 m radius and the frame 0.9 m over the ground while driving '
      .. 'are assumed',
    'ATHLETE: wheels, drives and steering, a cruise speed of 0.4 m/s and an acceleration of 0.1 '
      .. 'm/s2 are assumed',
    'ATHLETE: posture control that levels by 2 rad/s for each radian and yields by 0.5 mm/s for '
      .. 'each newton is assumed',
    'ATHLETE: a battery of 12 kWh with 0.96 either way, a panel of 3.2 m2 on a mast with 0.29 x '
      .. '0.9, loads of 150 W and 100 W of heaters in the dark, and an antenna on a mast of 3 m '
      .. 'that reaches 20 km and Earth, are assumed',
  },
}
