-- NASA Glenn's lunar simulant, finer than GRC-1, of middle density.
--
-- He et al. 2013, J. Aerospace Eng.: friction from 38 degrees loose to 48 degrees dense. Friction
-- and density are those of the table, between the two. Pressure-sinkage and cohesion are a row of a
-- table of simulants with citations, taken for every state; its kN and kPa are converted. The shear
-- modulus is that of nominal lunar soil, assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar simulant GRC-3, of middle density (He et al. 2013).',
  k_c               = 1000,
  k_phi             = 700e3,
  n                 = 0.9,
  cohesion_pa       = 400,
  friction_rad      = math.rad(42),
  density_kgpm3     = 1700,
  shear_modulus_x_m = 0.018,
}
