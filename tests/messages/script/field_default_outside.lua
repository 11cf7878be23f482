-- expect: number: 'Share': the default is outside min..max
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { share = lsos.number { kml = 'Share', max = 1, default = 2 } },
}
