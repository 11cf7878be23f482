-- expect: rover: step_s = 0.005: too long for the differential of rocker_left: omega x step is
-- as: rovers
-- after: rocker_rover.lua
differential.stiffness_n_m_prad = 1e6
return lsos.rover(whole())
