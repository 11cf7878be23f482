-- expect: integer: default = 1.5: must be a whole number
-- as: events
local lsos = require 'lsos'
return lsos.event {
  api = 1,
  doc = 'A case.',
  phases = { go = function() end },
  params = { crew = lsos.integer { kml = 'Crew', default = 1.5 } },
}
