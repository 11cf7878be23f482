-- expect: rover: station 'front' is steered: lsos.skid_steer steers none
-- as: rovers
-- after: skid_rover.lua
front.is_steered = true
return lsos.rover(whole())
