-- Lunar regolith below the loose top: the same pressure law, higher friction and density.
--
-- Row 'Apollo_regolith_nominal' of a table of soils that cites the Lunar Sourcebook (Heiken et al.
-- 1991, chapter 9). It has no shear modulus; that of ApolloNominal is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar regolith, dense: friction 46 degrees (Lunar Sourcebook 1991).',
  k_c               = 1400,
  k_phi             = 820e3,
  n                 = 1.0,
  cohesion_pa       = 170,
  friction_rad      = math.rad(46),
  density_kgpm3     = 1660,
  shear_modulus_x_m = 0.018,
}
