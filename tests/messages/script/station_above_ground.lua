-- expect: station: position_m: z must be 0, the wheels stand on the ground
-- as: rovers
local lsos = require 'lsos'
return lsos.station { name = 'front', position_m = lsos.vec3(1, 1, -0.1) }
