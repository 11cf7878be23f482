-- expect: asset: shapes: part = 'wheel': an asset has no parts that move
-- as: rovers
local lsos = require 'lsos'
return lsos.asset {
  api = 1, doc = 'A thing.',
  shapes = {
    lsos.shape { position_m = lsos.vec3(0, 0, 1), size_m = lsos.vec3(1, 1, 1), part = 'wheel' },
  },
}
