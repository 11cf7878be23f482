-- expect: joint: angle_min_rad and angle_max_rad are both 0: a joint must have a range to turn in
-- as: rovers
-- after: legged_rover.lua
limbs[3].joints[1].angle_min_rad, limbs[3].joints[1].angle_max_rad = 0, 0
return lsos.rover(whole())
