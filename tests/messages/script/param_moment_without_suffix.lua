-- expect: event: params: 'at' must end in '_s', as its value is in s
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { at = lsos.moment { kml = 'At' } },
}
