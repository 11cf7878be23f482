-- expect: resource: name = 'two\u001bparts': a name is text in UTF-8 without control characters
-- as: rovers
-- after: skid_rover.lua
rover.resources = { lsos.resource { name = 'two\27parts', unit = 'kg', amount = 1 } }
return lsos.rover(whole())
