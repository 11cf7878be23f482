-- expect: wheel: rolling_resistance = 2: must be 0..1
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { rolling_resistance = 2 }
