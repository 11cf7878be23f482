-- Sandy loam 2 of Shibly et al. 2005, as coded by others; seen at second hand.
--
-- Coded with a cohesion of 170 Pa; 1700 Pa is recalled. Friction 29 to 33 degrees. Density is
-- assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Sandy loam 2 (Shibly et al. 2005, second hand).',
  k_c               = 5270,
  k_phi             = 1515040,
  n                 = 0.7,
  cohesion_pa       = 1700,
  friction_rad      = math.rad(31),
  density_kgpm3     = 1550,
  shear_modulus_x_m = 0.025,
}
