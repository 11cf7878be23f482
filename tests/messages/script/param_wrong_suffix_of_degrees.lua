-- expect: event: params: 'slope_max_deg' must end in '_rad', as its value is in rad
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { slope_max_deg = lsos.number { kml = 'MaxSlope', unit = 'deg' } },
}
