-- expect: wheel_typo.lua:4: wheel: unknown key 'radius'; did you mean 'radius_m'?
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { radius = 0.5 }
