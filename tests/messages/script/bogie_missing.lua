-- expect: rover: station 'middle' is on the bogie, but there is no bogie
-- as: rovers
-- after: rocker_rover.lua
bogie = nil
return lsos.rover(whole())
