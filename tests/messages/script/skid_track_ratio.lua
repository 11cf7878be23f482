-- expect: skid_steer: turning_track_ratio = 0.5: must be at least 1
-- as: rovers
local lsos = require 'lsos'
return lsos.skid_steer { turning_track_ratio = 0.5 }
