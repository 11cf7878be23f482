-- expect: terrain: no soil 'Rok'; did you mean 'Rock'?
-- as: terrain
local lsos = require 'lsos'
return lsos.terrain {
  api = 1, doc = 'x', surface = lsos.plane {}, soil = 'ApolloNominal',
  soil_patches = {
    lsos.soil_patch { soil = 'Rok', lon_deg = { 0, 1, 1 }, lat_deg = { 0, 0, 1 } },
  },
}
