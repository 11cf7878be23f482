-- Poppy seed, loosely packed. Carries wheels of more than 29 mm width only: k_c is negative as
-- printed.
--
-- Agarwal et al. 2019, arXiv 1901.10667. Density is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Poppy seed, loose (Agarwal et al. 2019).',
  k_c               = -2.06e8,
  k_phi             = 7.07e9,
  n                 = 1.0,
  cohesion_pa       = 0,
  friction_rad      = math.rad(36),
  density_kgpm3     = 600,
  shear_modulus_x_m = 0.045,
}
