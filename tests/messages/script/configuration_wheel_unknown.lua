-- expect: rover: configuration 'A': no wheel 'front_left_whel'; did you mean 'front_left_wheel'?
-- as: rovers
-- after: skid_rover.lua
rover.configurations = {
  lsos.configuration { name = 'A', doc = 'Wrong.', locked_wheels = { 'front_left_whel' } },
}
return lsos.rover(whole())
