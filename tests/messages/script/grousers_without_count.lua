-- expect: rover: the wheel has a grouser_height_m but no grouser_count
-- as: rovers
-- after: skid_rover.lua
wheel.grouser_height_m = 0.01
return lsos.rover(whole())
