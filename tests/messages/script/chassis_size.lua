-- expect: chassis: size_m: all three must be more than 0 m
-- as: rovers
local lsos = require 'lsos'
return lsos.chassis { size_m = lsos.vec3(1, 2, 0) }
