-- A field array that follows the Sun, for rovers to plug into.
--
-- (A): our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local grey = '#9a9a98'

return lsos.asset {
  api  = 1,
  name = 'SolarArray',
  doc  = 'A solar array of 30 square metres that follows the Sun; rovers plug into it.',

  antenna_height_m = 1,  -- A

  panels = {
    lsos.panel {
      name       = 'Array',
      position_m = vec(0, 0, 4),  -- A
      length_m   = 5,                   -- A
      width_m    = 6,                   -- A
      efficiency = 0.29,                -- A: triple-junction cells
      factor     = 0.9,                 -- A: packing, wiring and conversion
      azimuth_min_rad   = -math.pi,
      azimuth_max_rad   = math.pi,
      elevation_min_rad = 0,
      elevation_max_rad = math.pi / 2,
      rate_radps        = math.rad(1),  -- A
    },
  },
  shapes = {
    box(vec(2, 2, 0.4), vec(0, 0, 0.2), grey),
    tube(0.12, 3.6, nil, vec(0, 0, 2.1), grey),
  },

  assumptions = {
    'SolarArray: 30 m2 with 0.29 x 0.9 on a mast of 4 m are assumed',
  },
}
