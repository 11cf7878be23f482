-- Crusted, cemented ground that wheels hardly mark. All numbers are assumed, of the order of stiff
-- desert soils; without pressure-sinkage parameters Terzaghi's bearing capacity serves.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Crusted ground that wheels hardly mark (assumed numbers).',
  cohesion_pa       = 20e3,
  friction_rad      = math.rad(35),
  density_kgpm3     = 1800,
  shear_modulus_x_m = 0.005,
}
