-- expect: terrain: soil: a soil's name or lsos.soil {...} is wanted, found a number
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { soil = 5 }
