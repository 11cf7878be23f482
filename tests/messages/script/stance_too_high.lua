-- expect: rover: configuration 'High': height_m = 3: limb_1 ends
-- as: rovers
-- after: legged_rover.lua
rover.configurations = { lsos.configuration { name = 'High', doc = 'Wrong.', height_m = 3 } }
return lsos.rover(whole())
