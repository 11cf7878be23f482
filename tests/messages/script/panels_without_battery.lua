-- expect: rover: panels without a battery: there is nothing to feed
-- as: rovers
-- after: skid_rover.lua
rover.panels = { lsos.panel { name = 'A', position_m = lsos.vec3(0, 0, 1), length_m = 1, width_m = 1, efficiency = 0.3 } }
return lsos.rover(whole())
