-- expect: plane: slope_rad = 10: must be 0..1.2 rad
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.plane { slope_rad = 10 } }
