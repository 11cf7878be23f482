-- expect: raster: 'file' is missing
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.raster {} }
