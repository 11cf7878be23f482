-- expect: rover: drive_calibration = 1.3: needs a drive_calibration_source
-- as: rovers
-- after: skid_rover.lua
rover.drive_calibration = 1.3
return lsos.rover(whole())
