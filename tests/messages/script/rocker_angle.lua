-- expect: rocker: angle_max_rad = 40: must be more than 0 and at most 1.5 rad
-- as: rovers
local lsos = require 'lsos'
return lsos.rocker { angle_max_rad = 40 }
