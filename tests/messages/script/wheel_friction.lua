-- expect: wheel: interface_friction_ratio = 1.2: must be more than 0 and at most 1
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { interface_friction_ratio = 1.2 }
