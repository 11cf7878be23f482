-- expect: rover: a differential ties rockers, and there is no rocker
-- as: rovers
-- after: skid_rover.lua
suspension.differential = lsos.differential {
  kind = 'gear', position_m = lsos.vec3(0, 0, 0.4), mass_kg = 3, stiffness_n_m_prad = 3000,
  damping_n_m_sprad = 40,
}
return lsos.rover(whole())
