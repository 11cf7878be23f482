-- expect: number: 'Speed': its role needs a unit of speed, not 'm'
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api    = 1,
  doc    = 'Drives.',
  drives = true,
  params = {
    speed_m = lsos.number { kml = 'Speed', unit = 'm', role = 'drive_speed' },
  },
  phases = { only = function() return lsos.done end },
}
