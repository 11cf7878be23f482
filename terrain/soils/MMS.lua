-- Mojave Martian Simulant.
--
-- Agarwal et al. 2019, arXiv 1901.10667 (rig at MIT). Density is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Mojave Martian Simulant (Agarwal et al. 2019).',
  k_c               = 846e3,
  k_phi             = 6.708e6,
  n                 = 1.4,
  cohesion_pa       = 600,
  friction_rad      = math.rad(35),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.0006,
}
