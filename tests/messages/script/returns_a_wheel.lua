-- expect: must return lsos.rover {...} or lsos.asset {...}, found a wheel
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel {
  radius_m = 0.5, width_m = 0.3, mass_kg = 30, normal_stiffness_npm = 1e5,
  normal_damping_nspm = 1e3, tangential_damping_nspm = 500,
}
