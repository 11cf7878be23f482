-- expect: module: position_m: z must be 0, the wheels stand on the ground
-- as: rovers
local lsos = require 'lsos'
return lsos.module { name = 'a', position_m = lsos.vec3(1, 2, 3) }
