-- Dry sand (Land Locomotion Laboratory).
--
-- Wong, Theory of Ground Vehicles, as cited by sample code of others; shear modulus 10 to 25 mm
-- there. Density is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Dry sand (Land Locomotion Laboratory, after Wong).',
  k_c               = 990,
  k_phi             = 1528430,
  n                 = 1.1,
  cohesion_pa       = 1040,
  friction_rad      = math.rad(28),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.015,
}
