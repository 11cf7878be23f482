-- expect: utc: unknown key 'default'
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { until_s = lsos.utc { kml = 'Until', default = 5 } },
}
