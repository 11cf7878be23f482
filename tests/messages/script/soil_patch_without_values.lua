-- expect: soil_patch: values is missing; which of the raster's mean this soil?
-- as: terrain
local lsos = require 'lsos'
return lsos.soil_patch { soil = 'Rock', raster = lsos.raster { file = 'a.tif' } }
