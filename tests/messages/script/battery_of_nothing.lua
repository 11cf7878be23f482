-- expect: battery: capacity_j = 0: must be more than 0 J
-- as: rovers
-- after: skid_rover.lua
rover.battery = lsos.battery { capacity_j = 0 }
return lsos.rover(whole())
