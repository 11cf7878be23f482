-- expect: soil_patch: lon_deg has 3 corners, lat_deg 2: as many are wanted, three at least
-- as: terrain
local lsos = require 'lsos'
return lsos.soil_patch { soil = 'Rock', lon_deg = { 1, 2, 3 }, lat_deg = { 1, 2 } }
