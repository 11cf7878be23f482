-- expect: raster: nodata: a number is wanted, found a text
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.raster { file = 'x.tif', nodata = 'none' } }
