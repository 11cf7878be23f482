-- expect: rover: 2 wheels: at least 3 are needed to stand on
-- as: rovers
-- after: skid_rover.lua
stations = { front }
return lsos.rover(whole())
