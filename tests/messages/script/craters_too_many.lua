-- expect: craters: density_pm2 = 1: at most 0.0889 craters of 3 m have room
-- as: terrain
local lsos = require 'lsos'
return lsos.craters { density_pm2 = 1 }
