-- Its soil patch lies elsewhere: longitudes and latitudes are exchanged.
local lsos = require 'lsos'

return lsos.terrain {
  api          = 1,
  doc          = 'A patch at 5, 31.',
  surface      = lsos.plane {},
  soil         = 'ApolloNominal',
  soil_patches = {
    lsos.soil_patch {
      soil = 'ApolloDense', lon_deg = { 5, 5.1, 5.1 }, lat_deg = { 31, 31, 31.1 },
    },
  },
}
