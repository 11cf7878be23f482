-- expect: event: params: 'speed' must end in '_mps', as its value is in m/s
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { speed = lsos.number { kml = 'Speed', unit = 'm/s' } },
}
