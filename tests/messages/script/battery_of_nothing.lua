-- expect: battery: capacity_j = 0: must be more than 0 and at most 1e+16 J
-- as: rovers
-- after: skid_rover.lua
rover.battery = lsos.battery { capacity_j = 0 }
return lsos.rover(whole())
