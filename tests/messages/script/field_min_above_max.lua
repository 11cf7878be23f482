-- expect: number: 'Share': min is above max
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { share = lsos.number { kml = 'Share', min = 2, max = 1 } },
}
