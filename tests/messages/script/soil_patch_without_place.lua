-- expect: soil_patch: a polygon (lon_deg, lat_deg) or a raster is wanted, and not both
-- as: terrain
local lsos = require 'lsos'
return lsos.soil_patch { soil = 'Rock' }
