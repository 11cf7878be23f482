-- expect: terrain: surface and layers: one of them is wanted
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { surface = lsos.plane {}, layers = { lsos.plane {} } }
