-- expect: rover: the chassis' centre of mass is not above the ground at rest
-- as: rovers
-- after: skid_rover.lua
chassis.center_of_mass_m = lsos.vec3(0, 0, -0.1)
return lsos.rover(whole())
