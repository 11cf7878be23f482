-- expect: raster: band: a number from 1 or a description is wanted, found 0
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.raster { file = 'x.tif', band = 0 } }
