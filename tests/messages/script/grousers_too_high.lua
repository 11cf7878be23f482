-- expect: rover: grouser_height_m = 0.2: must be less than the wheel's radius, 0.15 m
-- as: rovers
-- after: skid_rover.lua
wheel.grouser_height_m = 0.2
wheel.grouser_count = 12
return lsos.rover(whole())
