-- expect: wheel: interface_friction_ratio = 1.2: must be 0..1
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { interface_friction_ratio = 1.2 }
