-- A ring of walls that are too steep, 60 m east of 0, 0.
local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'Level but for one crater.',
  surface = lsos.relief {
    lon_deg = 0, lat_deg = 0,
    landforms = {
      lsos.landform {
        name = 'ring', lon_deg = 0.00197865, lat_deg = 0,
        diameter_m = 40, depth_m = 14, rim_height_m = 2,
      },
    },
  },
  soil = 'ApolloNominal',
}
