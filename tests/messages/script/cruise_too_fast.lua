-- expect: rover: cruise_speed_mps is above speed_max_mps
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { cruise_speed_mps = 3, speed_max_mps = 2 }
