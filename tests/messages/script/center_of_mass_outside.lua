-- expect: rover: the centre of mass of the whole, 0.656 m forward and 0.000 m to the left, is not over its wheels: it would tip over at rest
-- as: rovers
-- after: skid_rover.lua
chassis.center_of_mass_m = lsos.vec3(0.7, 0, 0.5)
return lsos.rover(whole())
