-- expect: rover: the wheel has a grouser_count but no grouser_height_m
-- as: rovers
-- after: skid_rover.lua
wheel.grouser_count = 12
return lsos.rover(whole())
