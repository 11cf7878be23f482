-- expect: rover: turning_radius_min_m = 1: front_left_steering would have to steer by 45 deg, its angle_max_rad is 29 deg
-- as: rovers
-- after: rocker_rover.lua
steering.angle_max_rad = 0.5
rover.turning_radius_min_m = 1
return lsos.rover(whole())
