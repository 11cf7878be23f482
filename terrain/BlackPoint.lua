-- The kind of ground of the field tests at Black Point, Arizona: a lava flow that ends in a low
-- cliff over a plain with washes. Synthetic: no map of the place is in it.
--
-- All shapes and sizes are assumptions: a flow 5 km across and 40 m over the plain, with washes.

local lsos = require 'lsos'

local height_m = 1700  -- A: of the plain above the ellipsoid

local landforms = {
  lsos.landform { name = 'lava flow', lon_deg = -111.47, lat_deg = 35.67, diameter_m = 5000,
                  rim_height_m = 40 },
  lsos.landform { name = 'ridge', lon_deg = -111.445, lat_deg = 35.69, diameter_m = 1200,
                  rim_height_m = 25 },
}
-- Washes: shallow hollows in a row.
for k = 0, 20 do
  landforms[#landforms + 1] = lsos.landform {
    name         = 'wash',
    lon_deg      = -111.50 + 0.0022 * k,
    lat_deg      = 35.645 + 0.0006 * k + 0.0008 * math.sin(0.7 * k),
    diameter_m   = 320,
    depth_m      = 4,
    rim_height_m = 0,
  }
end

return lsos.terrain {
  api = 1,
  doc = 'Synthetic lava flow with a ridge and washes, in the manner of Black Point, Arizona.',
  planet = 'Earth',

  surface = lsos.relief {
    lon_deg   = -111.47,
    lat_deg   = 35.67,
    height_m  = height_m,
    spacing_m = 8,
    landforms = landforms,
  },
  detail = lsos.detail {
    rocks     = lsos.rocks { cover = 0.01, diameter_min_m = 0.2, diameter_max_m = 1.5 },  -- A
    roughness = lsos.roughness { deviation_m = 0.02, hurst = 0.8 },                        -- A
  },
  soil = 'SandyLoam',
}
