-- The planetary simulant of HIT as fitted to measured wheels in it, within bounds: see
-- core/vehicle/VALIDATION.md.
--
-- Ding et al. 2011, J. Terramechanics 48(1), figure 9: smooth wheel. The fit takes 2.5 times the
-- published stiffness, which is its bound.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Planetary simulant of HIT, fitted to its smooth wheel (Ding et al. 2011).',
  k_c               = 15.6e3 * 2.5,
  k_phi             = 2407.4e3 * 2.5,
  n                 = 1.10,
  cohesion_pa       = 250,
  friction_rad      = math.rad(32.6),
  density_kgpm3     = 1605,
  shear_modulus_x_m = 0.0097,
  slip_sinkage      = 3.61,
}
