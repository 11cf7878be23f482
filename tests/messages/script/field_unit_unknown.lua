-- expect: number: unknown unit 'mps'; did you mean 'm/s'?
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { speed_mps = lsos.number { kml = 'Speed', unit = 'mps' } },
}
