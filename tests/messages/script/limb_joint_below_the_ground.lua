-- expect: rover: limb_1_knee is 0.200 m below the ground at rest
-- as: rovers
-- after: legged_rover.lua
limbs[1].joints[2].position_m = vec(0.9, 0.9, -0.2)
return lsos.rover(whole())
