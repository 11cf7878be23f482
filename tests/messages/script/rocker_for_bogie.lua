-- expect: rocker_bogie: bogie: lsos.bogie {...} is wanted, found a rocker
-- as: rovers
local lsos = require 'lsos'
return lsos.rocker_bogie { bogie = lsos.rocker {} }
