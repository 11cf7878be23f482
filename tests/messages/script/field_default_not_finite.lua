-- expect: number: default = inf: must be finite
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { share = lsos.number { kml = 'Share', default = math.huge } },
}
