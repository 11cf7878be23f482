-- expect: panel: at rest it stands at 1.5708 rad, outside elevation_min_rad and elevation_max_rad
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  panels = { lsos.panel { name = 'A', position_m = lsos.vec3(0, 0, 1), length_m = 1, width_m = 1, efficiency = 0.3, elevation_min_rad = 0, elevation_max_rad = 1, rate_radps = 1 } },
}
