-- expect: skid_steer: unknown key 'steering'
-- as: rovers
local lsos = require 'lsos'
return lsos.skid_steer { steering = lsos.steering {} }
