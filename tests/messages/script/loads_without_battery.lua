-- expect: rover: loads without a battery: there is nothing to feed them
-- as: rovers
-- after: skid_rover.lua
rover.loads = { lsos.load { name = 'lamp', power_w = 1 } }
return lsos.rover(whole())
