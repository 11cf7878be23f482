-- expect: terrain: layers: at least one is wanted
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { layers = {} }
