-- expect: chassis: size_m: lsos.vec3(x, y, z) is wanted, found a table
-- as: rovers
local lsos = require 'lsos'
return lsos.chassis { size_m = { 1, 2, 3 } }
