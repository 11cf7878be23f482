-- expect: station: on = 'arm': must be 'rocker' or 'bogie'
-- as: rovers
local lsos = require 'lsos'
return lsos.station { name = 'front', on = 'arm' }
