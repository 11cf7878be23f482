-- expect: wheel_missing.lua:4: wheel: 'width_m' is missing
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { radius_m = 0.5 }
