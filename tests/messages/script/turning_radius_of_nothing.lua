-- expect: rover: turning_radius_min_m = 0: must be more than 0 m unless can_turn_on_spot = true
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { turning_radius_min_m = 0 }
