-- Level ground for first tries.

local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'Level ground of nominal lunar soil.',

  surface = lsos.plane {},
  soil    = 'ApolloNominal',
}
