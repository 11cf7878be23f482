-- expect: rover: configuration 'High': height_m = 1: only a rover on limbs (lsos.legged) can stand higher or lower
-- as: rovers
-- after: skid_rover.lua
rover.configurations = { lsos.configuration { name = 'High', doc = 'Wrong.', height_m = 1 } }
return lsos.rover(whole())
