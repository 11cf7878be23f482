-- The sand of the CMU rig as fitted to measured wheels in it, within bounds: see
-- core/vehicle/VALIDATION.md.
--
-- Yu, Pavlov, Kim and Johnson 2024, J. Terramechanics 115: smooth wheel, straight rolling. The sand
-- is not characterised; DrySand with another stiffness, friction, cohesion and shear modulus.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Sand of a wheel rig at CMU, fitted to its smooth wheel (Yu et al. 2024).',
  k_c               = 990 * 1.4,
  k_phi             = 1528430 * 1.4,
  n                 = 1.1,
  cohesion_pa       = 520,
  friction_rad      = math.rad(33),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.0138,
  slip_sinkage      = 1.82,
}
