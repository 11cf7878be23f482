-- Lunar highland simulant (Shimizu).
--
-- Kanamori et al. 1998. Row of a table of simulants with citations; its kN and kPa are converted.
-- The shear modulus is not in it; that of nominal lunar soil is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar highland simulant FJS-1 (Kanamori et al. 1998).',
  k_c               = 1370,
  k_phi             = 820e3,
  n                 = 1.0,
  cohesion_pa       = 200,
  friction_rad      = math.rad(38),
  density_kgpm3     = 1500,
  shear_modulus_x_m = 0.018,
}
