-- expect: event: params: 'Speed' and 'Top' have the same role; one of them is allowed to
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api    = 1,
  doc    = 'Drives.',
  drives = true,
  params = {
    speed_mps = lsos.number { kml = 'Speed', unit = 'm/s', role = 'drive_speed' },
    top_mps   = lsos.number { kml = 'Top', unit = 'm/s', role = 'drive_speed' },
  },
  phases = { only = function() return lsos.done end },
}
