-- expect: rover: shapes: part = 'antenna': there is no such link
-- as: rovers
-- after: skid_rover.lua
rover.shapes = {
  lsos.shape { position_m = lsos.vec3(0, 0, 1), size_m = lsos.vec3(1, 1, 1), part = 'antenna' },
}
return lsos.rover(whole())
