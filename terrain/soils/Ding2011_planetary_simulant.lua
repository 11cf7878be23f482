-- Planetary soil simulant of wheel tests at HIT.
--
-- Ding et al. 2011, J. Terramechanics 48(1), table 2. Row of a table of simulants with citations;
-- its kN and kPa are converted. Shear modulus 9.7 to 13.1 mm there.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Planetary simulant of wheel tests at HIT (Ding et al. 2011).',
  k_c               = 15.6e3,
  k_phi             = 2407.4e3,
  n                 = 1.10,
  cohesion_pa       = 250,
  friction_rad      = math.rad(31.9),
  density_kgpm3     = 1605,
  shear_modulus_x_m = 0.011,
}
