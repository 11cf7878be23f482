-- expect: shape: size_m for a box, or radius_m and length_m for a cylinder, is wanted
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  shapes = { lsos.shape { position_m = lsos.vec3(0, 0, 1), radius_m = 1 } },
}
