-- expect: load: when = 'night': 'always', 'dark', 'parked' or 'driving' is wanted
-- as: rovers
-- after: skid_rover.lua
rover.battery = lsos.battery { capacity_j = 1e6 }
rover.loads = { lsos.load { name = 'lamp', power_w = 1, when = 'night' } }
return lsos.rover(whole())
