-- The kind of ground of the field tests at Black Point, Arizona: a lava flow whose edge is a broken
-- ridge over a plain with washes. Synthetic: no map of the place is in it.
--
-- All shapes and sizes are assumptions: a flow 5 km across and 40 m over the plain; along its
-- southern edge a ridge of 5 km, up to 45 m over the plain, with sides of up to 13 degrees to the
-- south and saddles between its summits; washes.

local lsos = require 'lsos'

local height_m = 1700  -- A: of the plain above the ellipsoid

-- A place in metres east and north of 111.466 W, 35.690 N, where the ridge has its western end.
local lon_deg, lat_deg = -111.466, 35.690
local function at(east_m, north_m)
  local degree_m = 111195
  return lon_deg + east_m / degree_m / math.cos(math.rad(lat_deg)), lat_deg + north_m / degree_m
end

local landforms = {}
local function add(name, east_m, north_m, diameter_m, rim_height_m, depth_m)
  local lon, lat = at(east_m, north_m)
  landforms[#landforms + 1] = lsos.landform {
    name = name, lon_deg = lon, lat_deg = lat, diameter_m = diameter_m, depth_m = depth_m,
    rim_height_m = rim_height_m,
  }
end

add('lava flow', 1000, 1700, 5000, 40)
-- The ridge: hills in a row that overlap, higher and lower ones, so that it has saddles; a wider
-- row behind them makes its northern side gentle.
for k = 0, 45 do
  local east_m = 250 + 112 * k
  local north_m = -190 - 6 * k + 55 * math.sin(0.33 * k) + 25 * math.sin(0.9 * k + 1)
  add('ridge', east_m, north_m, 520, 8 + 4 * math.sin(0.42 * k) + 2 * math.sin(1.13 * k))
  if k % 3 == 2 then add('ridge, back', east_m + 300, north_m + 220, 1000, 8) end
end
-- Washes: shallow hollows in a row.
for k = 0, 20 do
  add('wash', -3070 + 199 * k, -5000 + 67 * k + 89 * math.sin(0.7 * k), 320, 0, 4)
end

return lsos.terrain {
  api = 1,
  doc = 'Synthetic lava flow, a ridge along its edge and washes, as at Black Point, Arizona.',
  planet = 'Earth',

  surface = lsos.relief {
    lon_deg   = lon_deg,
    lat_deg   = lat_deg,
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
