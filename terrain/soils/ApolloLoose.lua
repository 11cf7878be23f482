-- Soft lunar regolith, as on crater rims and walls: the lower bounds of what was found.
--
-- Row 'Apollo_regolith_loose' of a table of soils that cites the bounds of the Lunar Sourcebook
-- (Heiken et al. 1991). It has no shear modulus; that of ApolloNominal is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar regolith, loose (lower bounds of the Lunar Sourcebook 1991).',
  k_c               = 500,
  k_phi             = 400e3,
  n                 = 1.0,
  cohesion_pa       = 100,
  friction_rad      = math.rad(30),
  density_kgpm3     = 1400,
  shear_modulus_x_m = 0.018,
}
