-- NASA Glenn's lunar simulant, finer than GRC-1.
--
-- He et al. 2013, J. Aerospace Eng. Row of a table of simulants with citations; its kN and kPa
-- are converted. The shear modulus is not in it; that of nominal lunar soil is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar simulant GRC-3 (He et al. 2013).',
  k_c               = 1000,
  k_phi             = 700e3,
  n                 = 0.9,
  cohesion_pa       = 400,
  friction_rad      = math.rad(42),
  density_kgpm3     = 1700,
  shear_modulus_x_m = 0.018,
}
