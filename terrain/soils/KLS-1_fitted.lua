-- Korean lunar simulant as fitted to measured wheels in it, within bounds: see
-- core/vehicle/VALIDATION.md.
--
-- Wang and Han 2016, J. Korean Geotech. Soc. 32(11): smooth wheel. The fit takes 40 times the
-- stiffness that another laboratory measured, which is its bound: sinkage in that bin is 1 to 8 mm.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Korean lunar simulant, fitted to a smooth wheel (Wang and Han 2016).',
  k_c               = -44055.4 * 40,
  k_phi             = 3581810.6 * 40,
  n                 = 1.2594,
  cohesion_pa       = 1716,
  friction_rad      = math.rad(36.5),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.027,
  slip_sinkage      = 2.94,
}
