-- expect: rover: two stations are named 'front'
-- as: rovers
-- after: skid_rover.lua
rear.name = 'front'
return lsos.rover(whole())
