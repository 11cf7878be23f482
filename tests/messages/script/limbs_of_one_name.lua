-- expect: rover: two limbs are named 'limb_1'
-- as: rovers
-- after: legged_rover.lua
limbs[2].name = 'limb_1'
return lsos.rover(whole())
