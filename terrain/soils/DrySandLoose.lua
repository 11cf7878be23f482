-- Loose dry sand of tilt-bed tests of small rovers. A reconstruction: pressure-sinkage of
-- DrySand, its cohesion nearly gone, friction and shear modulus chosen so that a wheel like that
-- of MER slips as recalled from tilt-bed tests (about 20 % at 10 degrees, near 100 % at 20
-- degrees).

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Loose dry sand, reconstructed from tilt-bed tests of small rovers.',
  k_c               = 990,
  k_phi             = 1528430,
  n                 = 1.1,
  cohesion_pa       = 100,
  friction_rad      = math.rad(34),
  density_kgpm3     = 1500,
  shear_modulus_x_m = 0.008,
}
