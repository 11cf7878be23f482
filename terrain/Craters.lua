-- Level ground with bowl craters; the plan's Seed decides where they are. Synthetic, no real place.
--
-- Numbers fall with the square of the diameter, as on old mare surfaces, but are kept sparser, so
-- that there is always a way round. Depth to diameter of worn small craters. Both are assumptions.

local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'Synthetic level ground with bowl craters of 3 to 60 m, of nominal lunar soil.',

  surface = lsos.craters {
    base              = lsos.plane {},
    diameter_min_m    = 3,
    diameter_max_m    = 60,
    exponent          = 2,
    density_pm2       = 2e-4,
    depth_to_diameter = 0.15,
  },
  soil = 'ApolloNominal',
}
