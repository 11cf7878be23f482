-- expect: rover: configuration 'A': the centre of mass of the whole, 1.592 m forward
-- as: rovers
-- after: skid_rover.lua
rover.configurations = {
  lsos.configuration {
    name = 'A', doc = 'Wrong.', payload_mass_kg = 500, payload_position_m = lsos.vec3(2, 0, 1),
  },
}
return lsos.rover(whole())
