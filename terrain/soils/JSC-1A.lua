-- Lunar mare simulant.
--
-- Zeng et al. 2010, J. Aerospace Eng. Row of a table of simulants with citations; its kN and kPa
-- are converted. The shear modulus is not in it; that of nominal lunar soil is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar mare simulant JSC-1A (Zeng et al. 2010).',
  k_c               = 1400,
  k_phi             = 820e3,
  n                 = 1.0,
  cohesion_pa       = 1000,
  friction_rad      = math.rad(45),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.018,
}
