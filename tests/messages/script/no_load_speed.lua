-- expect: drive: no_load_speed_radps = 0: must be more than 0 rad/s
-- as: rovers
local lsos = require 'lsos'
return lsos.drive { no_load_speed_radps = 0 }
