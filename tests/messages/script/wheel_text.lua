-- expect: wheel: radius_m: a number is wanted, found a text
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { radius_m = '0.5' }
