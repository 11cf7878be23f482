-- expect: shape: colour = 'red': red, green and blue as '#c0c0c0' is wanted
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  shapes = { lsos.shape { position_m = lsos.vec3(0, 0, 1), size_m = lsos.vec3(1, 1, 1), colour = 'red' } },
}
