-- expect: chassis: inertia_kgm2 = (1, 2, 4): no body has these: each moment must be at most the sum of the other two
-- as: rovers
local lsos = require 'lsos'
return lsos.chassis { inertia_kgm2 = lsos.vec3(1, 2, 4) }
