-- expect: rover: step_s = 1: must be 1e-05..0.1 s
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { step_s = 1 }
