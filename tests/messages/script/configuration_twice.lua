-- expect: rover: two configurations are named 'A'
-- as: rovers
-- after: skid_rover.lua
rover.configurations = {
  lsos.configuration { name = 'A', doc = 'One.' },
  lsos.configuration { name = 'A', doc = 'Another.' },
}
return lsos.rover(whole())
