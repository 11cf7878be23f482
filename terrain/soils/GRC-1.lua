-- NASA Glenn's lunar simulant for mobility tests, densely packed.
--
-- Oravec et al. 2010, J. Terramechanics 47: friction from 33 degrees loose to 38 degrees dense.
-- Pressure-sinkage and cohesion are a row of a table of simulants with citations, taken for both
-- states; its kN and kPa are converted. Density is the upper end of 1.60 to 1.89 g/cm3 (recalled).
-- The shear modulus is that of nominal lunar soil, assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar mobility simulant GRC-1, dense (Oravec et al. 2010).',
  k_c               = 700,
  k_phi             = 505e3,
  n                 = 0.8,
  cohesion_pa       = 250,
  friction_rad      = math.rad(38),
  density_kgpm3     = 1890,
  shear_modulus_x_m = 0.018,
}
