-- NASA Glenn's lunar simulant for mobility tests.
--
-- Oravec et al. 2010, J. Terramechanics 47. Row of a table of simulants with citations; its kN
-- and kPa are converted. The shear modulus is not in it; that of nominal lunar soil is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar mobility simulant GRC-1 (Oravec et al. 2010).',
  k_c               = 700,
  k_phi             = 505e3,
  n                 = 0.8,
  cohesion_pa       = 250,
  friction_rad      = math.rad(38),
  density_kgpm3     = 1620,
  shear_modulus_x_m = 0.018,
}
