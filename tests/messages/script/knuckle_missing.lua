-- expect: rocker_bogie: 'knuckle_mass_kg' is missing: a station is steered
-- as: rovers
local lsos = require 'lsos'
return lsos.rocker_bogie { stations = { lsos.station { name = 'front', is_steered = true } } }
