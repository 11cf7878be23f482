-- expect: wishbone: wheel: lsos.wheel {...} is wanted, found a plane
-- as: rovers
local lsos = require 'lsos'
return lsos.wishbone { wheel = lsos.plane {} }
