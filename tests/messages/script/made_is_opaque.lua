-- expect: what lsos.plane made cannot be looked into
-- as: rovers
local lsos = require 'lsos'
return lsos.plane {}.slope_rad
