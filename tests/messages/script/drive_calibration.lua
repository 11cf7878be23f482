-- expect: rover: drive_calibration = 0: must be more than 0
-- as: rovers
local lsos = require 'lsos'
return lsos.rover { drive_calibration = 0 }
