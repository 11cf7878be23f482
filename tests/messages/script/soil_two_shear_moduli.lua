-- expect: soil: shear_modulus_y_m must equal shear_modulus_x_m: one K serves all directions
-- as: terrain/soils
local lsos = require 'lsos'
return lsos.soil { shear_modulus_x_m = 0.02, shear_modulus_y_m = 0.01 }
