-- expect: panel: elevation_min_rad without elevation_max_rad: an axis that turns has both ends
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  panels = { lsos.panel { name = 'A', position_m = lsos.vec3(0, 0, 1), length_m = 1, width_m = 1, efficiency = 0.3, elevation_min_rad = 0, rate_radps = 1 } },
}
