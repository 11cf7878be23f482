-- expect: wheel: radius_m = -1: must be more than 0 and at most 10 m
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { radius_m = -1 }
