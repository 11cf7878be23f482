-- expect: craters: diameter_min_m is above diameter_max_m
-- as: terrain
local lsos = require 'lsos'
return lsos.craters { diameter_min_m = 100 }
