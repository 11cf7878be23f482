-- expect: shape: axis: a direction is wanted, found 0, 0, 0
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  shapes = {
    lsos.shape {
      position_m = lsos.vec3(0, 0, 1), radius_m = 1, length_m = 1, axis = lsos.vec3(0, 0, 0),
    },
  },
}
