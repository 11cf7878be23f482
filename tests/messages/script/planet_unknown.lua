-- expect: terrain: planet = 'Pluto': Moon, Mars or Earth is wanted
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain { planet = 'Pluto' }
