-- Lunar simulant of steering tests with a 0.09 m wheel.
--
-- Ishigami et al. 2007, as coded by others; seen at second hand. Shear moduli k_x = 0.043 b +
-- 0.036 for slip angles in rad, at 0.11 rad here, and density are recalled, not read.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar simulant of Ishigami et al. 2007 (second hand).',
  k_c               = 1370,
  k_phi             = 814e3,
  n                 = 1.00,
  cohesion_pa       = 800,
  friction_rad      = math.rad(37.2),
  density_kgpm3     = 1600,
  shear_modulus_x_m = 0.041,
  shear_modulus_y_m = 0.015,
}
