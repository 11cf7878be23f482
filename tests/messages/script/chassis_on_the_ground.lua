-- expect: rover: the chassis' underside is not above the ground at rest
-- as: rovers
-- after: skid_rover.lua
chassis.clearance_m = 0
return lsos.rover(whole())
