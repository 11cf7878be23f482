-- expect: rover: the bogie's pivot at x = 0.1 m is not between its stations, -0.5 to 0 m: it would tip over
-- as: rovers
-- after: rocker_rover.lua
bogie.pivot_m = lsos.vec3(0.1, 0.4, 0.25)
return lsos.rover(whole())
