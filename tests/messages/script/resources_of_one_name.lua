-- expect: rover: resources: 'oxygen' is the name of two
-- as: rovers
-- after: skid_rover.lua
rover.resources = {
  lsos.resource { name = 'oxygen', unit = 'kg', amount = 1 },
  lsos.resource { name = 'oxygen', unit = 'kg', amount = 2 },
}
return lsos.rover(whole())
