-- expect: rocks: diameter_min_m is above diameter_max_m
-- as: terrain
local lsos = require 'lsos'
return lsos.rocks { diameter_min_m = 2, diameter_max_m = 1 }
