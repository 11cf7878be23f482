-- expect: terrain: surface: lsos.plane, lsos.craters or lsos.raster is wanted, found a soil
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.soil {} }
