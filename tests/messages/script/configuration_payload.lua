-- expect: rover: configuration 'A': payload_mass_kg = -200: the chassis has only 120 kg to take off
-- as: rovers
-- after: skid_rover.lua
rover.configurations = {
  lsos.configuration { name = 'A', doc = 'Wrong.', payload_mass_kg = -200 },
}
return lsos.rover(whole())
