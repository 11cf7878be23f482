-- expect: is not between the rockers' wheels and the bogies' pivots, -0.250 to 0.500 m: it would tip over at rest
-- as: rovers
-- after: rocker_rover.lua
chassis.center_of_mass_m = lsos.vec3(-0.4, 0, 0.5)
return lsos.rover(whole())
