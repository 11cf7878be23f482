-- expect: rover: step_s = 0.005: too long for the wheel's normal spring of front_left_wheel: omega x step is 1.12
-- as: rovers
-- after: rocker_rover.lua
wheel.normal_stiffness_npm = 1e5
return lsos.rover(whole())
