-- expect: rocker: inertia_kgm2: all three must be more than 0 kg m2
-- as: rovers
local lsos = require 'lsos'
return lsos.rocker { inertia_kgm2 = lsos.vec3(1, -1, 1) }
