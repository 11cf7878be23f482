-- expect: rover: can_crab: not all of its wheels are steered
-- as: rovers
-- after: skid_rover.lua
rover.can_crab = true
return lsos.rover(whole())
