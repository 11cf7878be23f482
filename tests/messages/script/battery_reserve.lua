-- expect: battery: reserve = 20: must be
-- as: rovers
-- after: skid_rover.lua
rover.battery = lsos.battery { capacity_j = 1e6, reserve = 20 }
return lsos.rover(whole())
