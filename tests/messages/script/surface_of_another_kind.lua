-- expect: terrain: surface: lsos.raster, lsos.relief or lsos.plane is wanted, found a soil
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.soil {} }
