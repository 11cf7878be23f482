-- expect: rover: step_s = 0.005: too long for the limb's servo of limb_1_hip: omega x step is
-- as: rovers
-- after: legged_rover.lua
motor.stiffness_n_m_prad = 1e7
return lsos.rover(whole())
