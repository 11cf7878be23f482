-- expect: rover: limb 'limb_3' has no joints: it needs at least one
-- as: rovers
-- after: legged_rover.lua
limbs[3].joints = {}
return lsos.rover(whole())
