-- expect: rover: step_s = 0.005: too long for the limb's servo of limb_1_hip: damping x step / inertia is
-- as: rovers
-- after: legged_rover.lua
motor.damping_n_m_sprad = 1e5
return lsos.rover(whole())
