-- A relay station: a mast with an antenna.
--
-- (A): our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local grey, gold = '#9a9a98', '#c8a040'

return lsos.asset {
  api  = 1,
  name = 'CommStation',
  doc  = 'A relay station: an antenna on a mast, powered by a panel of its own.',

  antenna_height_m    = 10,    -- A
  antenna_range_max_m = 30e3,  -- A

  shapes = {
    box(vec(1.5, 1.5, 0.8), vec(0, 0, 0.4), gold),
    tube(0.08, 9, nil, vec(0, 0, 5.2), grey),
    tube(0.6, 0.1, vec(1, 0, 0.5), vec(0.2, 0, 8.6), grey),
  },

  assumptions = {
    'CommStation: an antenna at 10 m that reaches 30 km and Earth is assumed',
  },
}
