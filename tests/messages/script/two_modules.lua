-- expect: rover: 2 modules: at least 3 are needed to stand on
-- as: rovers
-- after: wishbone_rover.lua
modules = { modules[1], modules[2] }
return lsos.rover(whole())
