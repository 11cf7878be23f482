-- expect: soil: k_phi without k_c: Bekker's law needs all of k_c, k_phi and n; without any of them Terzaghi's is used
-- as: terrain/soils
local lsos = require 'lsos'
return lsos.soil { k_phi = 8e5 }
