-- expect: configuration: joints: NAME = number is wanted throughout
-- as: rovers
local lsos = require 'lsos'
return lsos.configuration { joints = { rocker_left = 'up' } }
