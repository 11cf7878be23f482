-- Second soil of the MIT rig. Carries wheels of more than 6.6 mm width only: k_c is negative as
-- printed.
--
-- Agarwal et al. 2019, arXiv 1901.10667. Density is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Soil MS of the MIT rig (Agarwal et al. 2019).',
  k_c               = -2.05e7,
  k_phi             = 3.13e9,
  n                 = 1.0,
  cohesion_pa       = 1500,
  friction_rad      = math.rad(34),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.0006,
}
