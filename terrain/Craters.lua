-- Level ground with bowl craters; the plan's Seed decides where they are. Synthetic, no real place.
--
-- Numbers fall with the square of the diameter, as on old mare surfaces, at a tenth of the density
-- in equilibrium (Trask 1966: 10^-1.1 D^-2 a m2, 9e-3 for D > 3 m), so that there is always a way
-- round. Depth to diameter of worn small craters, an assumption.

local lsos = require 'lsos'

return lsos.terrain {
  api = 1,
  doc = 'Synthetic level ground with bowl craters of 3 to 60 m, of nominal lunar soil.',

  surface = lsos.plane {},
  detail  = lsos.detail {
    craters = lsos.craters {
      diameter_min_m    = 3,
      diameter_max_m    = 60,
      exponent          = 2,
      density_pm2       = 9e-4,
      depth_to_diameter = 0.08,
    },
  },
  soil = 'ApolloNominal',
}
