-- expect: rover: configuration 'A': no joint 'rocker_lft'; did you mean 'rocker_left'?
-- as: rovers
-- after: rocker_rover.lua
rover.configurations = {
  lsos.configuration { name = 'A', doc = 'Wrong.', joints = { rocker_lft = 0.1 } },
}
return lsos.rover(whole())
