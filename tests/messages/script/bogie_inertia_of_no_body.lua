-- expect: bogie: inertia_kgm2 = (0.1, 0.5, 0.3): no body has these: each moment must be at most the sum of the other two
-- as: rovers
local lsos = require 'lsos'
return lsos.bogie { inertia_kgm2 = lsos.vec3(0.1, 0.5, 0.3) }
