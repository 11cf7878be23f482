-- expect: rover: can_turn_on_spot: front_left_steering would have to steer by 45 deg, its angle_max_rad is 29 deg
-- as: rovers
-- after: rocker_rover.lua
steering.angle_max_rad = 0.5
rover.can_turn_on_spot = true
return lsos.rover(whole())
