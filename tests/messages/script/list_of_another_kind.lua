-- expect: wishbone: modules[1]: lsos.module {...} is wanted, found a table
-- as: rovers
local lsos = require 'lsos'
return lsos.wishbone { modules = { {} } }
