-- An even slope of 10 degrees that falls to the north.

local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'A 10 degree slope that falls to the north, of nominal lunar soil.',

  surface = lsos.plane { slope_rad = math.rad(10), downslope_azimuth_rad = 0 },
  soil    = 'ApolloNominal',
}
