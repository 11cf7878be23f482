-- expect: raster: unit: 'feat' is no unit of length; m, km, dm, cm, mm, ft, us-ft are allowed; did you mean 'ft'?
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.raster { file = 'x.tif', unit = 'feat' } }
