-- Bare rock: wheels do not sink. Friction of metal treads on basalt is assumed.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Bare rock (assumed friction 0.7).',
  is_rigid          = true,
  cohesion_pa       = 0,
  friction_rad      = math.atan(0.7),
  density_kgpm3     = 2900,
  shear_modulus_x_m = 0.002,
}
