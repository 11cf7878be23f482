-- Lunar regolith as usually taken for mobility estimates.
--
-- Bekker and Mohr-Coulomb values of the Lunar Sourcebook (Heiken, Vaniman, French 1991, chapter 9)
-- as tabulated in course material; seen at second hand. Density 1520 kg/m3 at 0 to 15 cm.

local lsos = require 'lsos'

return lsos.soil {
  doc               = 'Lunar regolith, nominal (Lunar Sourcebook 1991).',
  k_c               = 1400,
  k_phi             = 820e3,
  n                 = 1.0,
  cohesion_pa       = 170,
  friction_rad      = math.rad(35),
  density_kgpm3     = 1520,
  shear_modulus_x_m = 0.018,
}
