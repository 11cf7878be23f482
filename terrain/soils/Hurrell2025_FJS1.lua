-- FJS-1 as in the Rashid-1 wheel tests, loose.
--
-- Hurrell et al. 2025, table 2 (cohesion after Ozaki et al. 2023); pressure-sinkage is that of
-- FJS-1. Row of a table of simulants with citations; its kN and kPa are converted. The shear
-- modulus is not in it; that of nominal lunar soil is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'FJS-1 as characterised by Hurrell et al. 2025, loose.',
  k_c               = 1370,
  k_phi             = 820e3,
  n                 = 1.0,
  cohesion_pa       = 2400,
  friction_rad      = math.rad(38),
  density_kgpm3     = 1740,
  shear_modulus_x_m = 0.018,
}
