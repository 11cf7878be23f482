-- expect: wishbone: wheel_offsets_m[2]: a number is wanted, found a text
-- as: rovers
local lsos = require 'lsos'
return lsos.wishbone { wheel_offsets_m = { 0.2, 'x' } }
