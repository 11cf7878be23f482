-- expect: rover: configuration 'Bent': limb_1_wheel: its hub is
-- as: rovers
-- after: legged_rover.lua
rover.configurations = {
  lsos.configuration { name = 'Bent', doc = 'Wrong.', joints = { limb_1_hip = 0.5 } },
}
return lsos.rover(whole())
