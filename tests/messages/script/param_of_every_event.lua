-- expect: event: params: 'Timeout' is a field that every event has
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { timeout_s = lsos.duration { kml = 'Timeout' } },
}
