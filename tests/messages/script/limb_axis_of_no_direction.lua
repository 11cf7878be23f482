-- expect: joint: axis: (0, 0, 0) is no direction
-- as: rovers
-- after: legged_rover.lua
limbs[3].joints[1].axis = vec(0, 0, 0)
return lsos.rover(whole())
