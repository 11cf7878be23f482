-- expect: rover: suspension: lsos.wishbone, lsos.rocker_bogie, lsos.skid_steer or lsos.legged is wanted, found a spring
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { suspension = lsos.spring {} }
