-- expect: terrain: rock_soil: a soil's name or lsos.soil {...} is wanted, found a plane
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { rock_soil = lsos.plane {} }
