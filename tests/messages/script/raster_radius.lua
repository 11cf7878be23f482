-- expect: raster: is_radius: true or false is wanted, found
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.raster { file = 'x.tif', is_radius = 1 } }
