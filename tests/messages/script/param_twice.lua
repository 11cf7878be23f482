-- expect: event: params: 'Speed' is the name of two fields
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { a_mps = lsos.number { kml = 'Speed', unit = 'm/s' }, b_mps = lsos.number { kml = 'Speed', unit = 'm/s' } },
}
