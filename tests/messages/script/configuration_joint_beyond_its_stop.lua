-- expect: rover: configuration 'A': bogie_left = 0.9: must be -0.6..0.6 rad
-- as: rovers
-- after: rocker_rover.lua
rover.configurations = {
  lsos.configuration { name = 'A', doc = 'Wrong.', joints = { bogie_left = 0.9 } },
}
return lsos.rover(whole())
