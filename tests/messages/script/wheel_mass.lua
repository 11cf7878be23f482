-- expect: wheel: mass_kg = 0: must be more than 0 kg
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { mass_kg = 0 }
