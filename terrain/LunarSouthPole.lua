-- The Moon's south pole: craters and massifs within some 200 km at their published places and
-- sizes, with craters, rocks and roughness between them by the plan's Seed. Analytic shapes, not
-- measured ground: rims, ridges and permanent shadow lie about where they should, a slope is not
-- the slope of a map. A raster of LOLA heights is better where one is at hand (see README.md).
--
-- Positions and diameters: (V) USGS/IAU Gazetteer of Planetary Nomenclature, list of 2025; (R) the
-- same, recalled. Depths are (D) 1.044 D^0.301 km (Pike 1980, fresh complex craters) where none is
-- named; rims of 0.2 of the depth and all else are (A) assumed.

local lsos = require 'lsos'

local function crater(name, lon_deg, lat_deg, diameter_km, depth_km)
  depth_km = depth_km or 1.044 * diameter_km ^ 0.301
  return lsos.landform {
    name         = name,
    lon_deg      = lon_deg,
    lat_deg      = lat_deg,
    diameter_m   = diameter_km * 1000,
    depth_m      = depth_km * 1000,
    rim_height_m = 0.2 * depth_km * 1000,
  }
end

local function massif(name, lon_deg, lat_deg, diameter_km, height_km)
  return lsos.landform {
    name         = name,
    lon_deg      = lon_deg,
    lat_deg      = lat_deg,
    diameter_m   = diameter_km * 1000,
    rim_height_m = height_km * 1000,
  }
end

return lsos.terrain {
  api = 1,
  doc = 'South pole of the Moon: named craters at their places, seeded detail; synthetic.',
  planet = 'Moon',

  surface = lsos.relief {
    lon_deg  = 0,
    lat_deg  = -90,
    height_m = 0,
    landforms = {
      crater('Shackleton',   129.78, -89.67, 20.92, 4.2),  -- R; V: 21 km, 4.2 km deep, encyclopedia
      crater('de Gerlache',  -88.34, -88.48, 32.71),       -- R
      crater('Sverdrup',    -152.17, -88.32, 32.80),       -- R
      crater('Slater',       111.29, -88.08, 25.10),       -- R
      crater('Shoemaker',     45.91, -88.14, 51.82),       -- V
      crater('Haworth',       -5.17, -87.45, 51.42),       -- V
      crater('Faustini',      84.31, -87.18, 42.48),       -- R; 85.0 E in older lists
      crater('Nobile',        53.27, -85.28, 79.27),       -- V
      crater('Cabeus',       -42.13, -85.33, 100.58, 4.0), -- V; A: depth
      crater('Malapert',      11.40, -85.00, 72.38),       -- V
      crater('Amundsen',      83.07, -84.44, 103.39),      -- V
      crater('Wiechert',     165.00, -84.50, 41.00),       -- R
      crater('Idel\'son L',  115.80, -84.20, 28.00),       -- R
      crater('Scott',         48.52, -82.35, 107.82),      -- V
      crater('Idel\'son',    112.69, -81.35, 59.82),       -- V
      crater('Ashbrook',    -110.58, -81.10, 157.68),      -- V
      massif('Mons Malapert',  -2.32, -85.96, 50, 4.0),    -- V place; A: some 5 km above the plains
      massif('Mons Mouton',    31.00, -84.60, 100, 3.5),   -- V place; A: height and width
    },
  },

  detail = lsos.detail {
    -- A: old ground; Shackleton itself is 3.6 Gyr old.
    craters = lsos.craters {
      age_gyr        = 3.9,
      diameter_min_m = 1,
      diameter_max_m = 2000,
    },
    rocks     = lsos.rocks { cover = 0.005, diameter_min_m = 0.2 },      -- A
    roughness = lsos.roughness { deviation_m = 0.01, hurst = 0.7 },      -- A
  },
  soil = 'ApolloNominal',
}
