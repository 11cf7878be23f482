-- expect: too_stiff_for_the_step.lua:51: rover: step_s = 0.005: too long for the wheel's normal spring of front_left_wheel_1
-- as: rovers
-- after: wishbone_rover.lua
wheel.normal_stiffness_npm = 1e8
return lsos.rover(whole())
