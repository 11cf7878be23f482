-- expect: event: at = 'when_s': no lsos.moment of params has that key
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  at = 'when_s',
  params = { when_s = lsos.utc { kml = 'When' } },
}
