-- expect: number: 'Share' is required and has a default: one of the two
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { share = lsos.number { kml = 'Share', required = true, default = 2 } },
}
