-- A habitat with a power plant of its own.
--
-- (A): our assumption, which summary.json repeats.

local lsos = require 'lsos'
local drawn = require 'lib/shapes'
local vec = lsos.vec3
local box, tube = drawn.box, drawn.tube

local white, grey, dark = '#e8e8e4', '#9a9a98', '#30343a'

return lsos.asset {
  api  = 1,
  name = 'Habitat',
  doc  = 'A habitat for a crew of four, with an antenna and power to give.',

  antenna_height_m = 8,     -- A
  supply_w         = 5000,  -- A: from its own plant, day and night

  shapes = {
    tube(2.5, 9, vec(1, 0, 0), vec(0, 0, 3.2), white),
    tube(1.2, 2, vec(1, 0, 0), vec(5.4, 0, 2.2), grey),
    box(vec(0.1, 1.1, 1.8), vec(6.4, 0, 2.0), dark),
    box(vec(0.4, 5, 0.7), vec(3, 0, 0.35), grey),
    box(vec(0.4, 5, 0.7), vec(-3, 0, 0.35), grey),
    tube(0.06, 2.4, nil, vec(-3.5, 0, 6.8), grey),
  },

  assumptions = {
    'Habitat: 5 kW to give at any time and an antenna at 8 m are assumed',
  },
}
