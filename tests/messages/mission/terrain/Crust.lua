-- Its soil carries wide wheels only.
local lsos = require 'lsos'

return lsos.terrain {
  api     = 1,
  doc     = 'Crust.',
  surface = lsos.plane {},
  soil    = lsos.soil {
    k_c = -5e6, k_phi = 1e7, n = 1, cohesion_pa = 0, friction_rad = 0.5, density_kgpm3 = 1600,
    shear_modulus_x_m = 0.01,
  },
}
