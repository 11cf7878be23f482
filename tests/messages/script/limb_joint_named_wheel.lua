-- expect: rover: limb 'limb_1': no joint may be named 'wheel', which is the name of another part of it
-- as: rovers
-- after: legged_rover.lua
limbs[1].joints[1].name = 'wheel'
return lsos.rover(whole())
