-- expect: rover: the rockers turn freely: they need a differential to hold the chassis
-- as: rovers
-- after: skid_rover.lua
suspension.rocker = lsos.rocker {
  pivot_m = lsos.vec3(0, 0.4, 0.4), mass_kg = 4, angle_max_rad = 0.6,
  stop_stiffness_n_m_prad = 500, stop_damping_n_m_sprad = 20,
}
return lsos.rover(whole())
