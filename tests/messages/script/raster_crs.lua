-- expect: raster: crs: a text is wanted, found
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.raster { file = 'x.tif', crs = 30135 } }
