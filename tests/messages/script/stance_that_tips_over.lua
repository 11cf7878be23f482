-- expect: rover: the centre of mass of the whole, 1.364 m forward and 0.000 m to the left, is not over its wheels
-- as: rovers
-- after: legged_rover.lua
chassis.center_of_mass_m = vec(2.4, 0, 0.75)
return lsos.rover(whole())
