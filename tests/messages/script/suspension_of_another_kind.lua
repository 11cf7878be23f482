-- expect: rover: suspension: lsos.wishbone, lsos.rocker_bogie or lsos.skid_steer is wanted, found a spring
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { suspension = lsos.spring {} }
