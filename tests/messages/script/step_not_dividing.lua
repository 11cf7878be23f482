-- expect: rover: step_s = 0.003: must divide the exchange period of 0.1 s, as 0.005 does
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { step_s = 0.003 }
