-- expect: terrain: layers: an array is wanted, found a number
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { layers = 7 }
