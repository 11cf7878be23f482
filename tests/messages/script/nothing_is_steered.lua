-- expect: rover: no wheel is steered: lsos.skid_steer is for rovers that turn without
-- as: rovers
-- after: rocker_rover.lua
front.is_steered = false
rear.is_steered = false
return lsos.rover(whole())
