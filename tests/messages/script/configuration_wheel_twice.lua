-- expect: rover: configuration 'A': wheel 'rear_left_wheel' is named twice in free_wheels and locked_wheels
-- as: rovers
-- after: skid_rover.lua
rover.configurations = {
  lsos.configuration {
    name = 'A', doc = 'Wrong.', free_wheels = { 'rear_left_wheel' },
    locked_wheels = { 'rear_left_wheel' },
  },
}
return lsos.rover(whole())
