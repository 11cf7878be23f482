-- expect: event: params: 'length_m' ends like a value in m, but its unit is '1'
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { length_m = lsos.number { kml = 'Length' } },
}
