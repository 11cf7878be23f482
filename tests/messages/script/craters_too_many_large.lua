-- expect: craters of 500 m and more per m2; at most 3.2e-06 have room
-- as: terrain
local lsos = require 'lsos'
return lsos.craters { density_pm2 = 0.01, exponent = 0.5, diameter_max_m = 1000 }
