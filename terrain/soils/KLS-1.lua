-- Korean lunar simulant, relative density about 60 %.
--
-- Shear strength and modulus: Wang and Han 2016. Pressure-sinkage: bevameter fit of Lim et al.
-- 2021, another laboratory; its negative k_c is as printed. Row of a table of simulants with
-- citations; its kN and kPa are converted.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Korean lunar simulant KLS-1 (Wang and Han 2016, Lim et al. 2021).',
  k_c               = -44055.4,
  k_phi             = 3581810.6,
  n                 = 1.2594,
  cohesion_pa       = 1716,
  friction_rad      = math.rad(40.6),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.018,
}
