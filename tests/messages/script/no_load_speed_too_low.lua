-- expect: rover: no_load_speed_radps = 1.5: speed_max_mps needs more than 2.000 rad/s
-- as: rovers
-- after: skid_rover.lua
drive.no_load_speed_radps = 1.5
return lsos.rover(whole())
