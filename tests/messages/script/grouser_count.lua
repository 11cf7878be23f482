-- expect: wheel: grouser_count = 12.5: must be a whole number
-- as: rovers
local lsos = require 'lsos'
return lsos.wheel { grouser_count = 12.5 }
