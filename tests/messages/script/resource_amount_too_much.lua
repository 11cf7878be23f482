-- expect: resource: amount = 1e+21: must be 0..1e+16
-- as: rovers
-- after: skid_rover.lua
rover.resources = { lsos.resource { name = 'data', unit = 'bit', amount = 1e21 } }
return lsos.rover(whole())
