-- expect: returns_a_rover_part.lua: must return lsos.event {...}, found a plane
-- as: events
local lsos = require 'lsos'
return lsos.plane {}
