-- expect: rover: station 'front': position_m: y = -0.5 is on the right; the left wheel's place is wanted
-- as: rovers
-- after: skid_rover.lua
front.position_m = lsos.vec3(0.5, -0.5, 0)
return lsos.rover(whole())
