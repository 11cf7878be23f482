-- Steeper than the soil can hold.
local lsos = require 'lsos'

return lsos.terrain {
  api     = 1,
  doc     = 'Steep.',
  surface = lsos.plane { slope_rad = math.rad(50) },
  soil    = 'ApolloNominal',
}
