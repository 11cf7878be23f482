-- expect: panel: azimuth_min_rad = 1 is above azimuth_max_rad = -1
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  panels = { lsos.panel { name = 'A', position_m = lsos.vec3(0, 0, 1), length_m = 1, width_m = 1, efficiency = 0.3, azimuth_min_rad = 1, azimuth_max_rad = -1, rate_radps = 1 } },
}
