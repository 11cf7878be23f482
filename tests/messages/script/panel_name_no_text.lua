-- expect: panel: name = 'pan\xffel': a name is text in UTF-8 without control characters
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  panels = { lsos.panel { name = 'pan\xffel', position_m = lsos.vec3(0, 0, 1), length_m = 1, width_m = 1, efficiency = 0.3 } },
}
