-- expect: wishbone: 'steering' is missing: a module is steered
-- as: rovers
local lsos = require 'lsos'
return lsos.wishbone { modules = { lsos.module { name = 'front_left' } }, knuckle_mass_kg = 2 }
