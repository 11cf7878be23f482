-- expect: wheel: inertia_kgm2 = (1, 0.5, 0.3): no wheel has these: the first and the last moment each must be at most the sum of the other two
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { inertia_kgm2 = lsos.vec3(1, 0.5, 0.3) }
