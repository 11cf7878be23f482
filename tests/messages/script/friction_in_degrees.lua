-- expect: soil: friction_rad = 35: must be 0..1.3 rad
-- as: terrain/soils
local lsos = require 'lsos'
return lsos.soil { friction_rad = 35 }
