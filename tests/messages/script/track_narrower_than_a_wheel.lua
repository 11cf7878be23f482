-- expect: rover: station 'front': the track of 0.08 m is narrower than a wheel, 0.1 m
-- as: rovers
-- after: skid_rover.lua
front.position_m = lsos.vec3(0.5, 0.04, 0)
return lsos.rover(whole())
