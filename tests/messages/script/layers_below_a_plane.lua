-- expect: terrain: layers[1]: only the last may be lsos.relief or lsos.plane, which have no end
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { layers = { lsos.plane {}, lsos.raster { file = 'a.tif' } } }
