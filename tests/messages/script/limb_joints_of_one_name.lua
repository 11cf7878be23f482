-- expect: rover: limb 'limb_2' has two joints named 'hip'
-- as: rovers
-- after: legged_rover.lua
limbs[2].joints[2].name = 'hip'
return lsos.rover(whole())
