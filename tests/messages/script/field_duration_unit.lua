-- expect: duration: 'Hold': the unit of a duration is s, min, h or d, not 'm'
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { hold_m = lsos.duration { kml = 'Hold', unit = 'm' } },
}
