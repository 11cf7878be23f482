-- expect: configuration: joints: a table is wanted, found a number
-- as: rovers
local lsos = require 'lsos'
return lsos.configuration { joints = 0.2 }
