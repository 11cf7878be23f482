-- expect: rover: step_s = 0.005: too long for the drive servo of front_left_wheel: damping x step / inertia is
-- as: rovers
-- after: skid_rover.lua
drive.servo_gain_n_m_sprad = 200
return lsos.rover(whole())
