-- expect: soil: k_phi = 0: must be more than 0
-- as: terrain/soils
local lsos = require 'lsos'
return lsos.soil { k_phi = 0 }
