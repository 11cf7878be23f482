-- expect: terrain: layers[2]: lsos.raster, lsos.relief or lsos.plane is wanted, found a rocks
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { layers = { lsos.raster { file = 'a.tif' }, lsos.rocks {} } }
