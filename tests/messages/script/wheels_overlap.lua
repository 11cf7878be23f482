-- expect: rover: front_left_wheel and rear_left_wheel overlap: 0.200 m apart along and 0.000 m across
-- as: rovers
-- after: skid_rover.lua
front.position_m = lsos.vec3(0.1, 0.5, 0)
rear.position_m = lsos.vec3(-0.1, 0.5, 0)
return lsos.rover(whole())
